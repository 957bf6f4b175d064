using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Grids;

/// <summary>
/// The voxels that a camera sees, by the depth map of its picture: an occupied voxel if the surface that some pixel shows, at its middle,
/// lies in it; a free one if its middle is in the image and not farther than the surface that the pixel there shows.
/// </summary>
public static class VoxelSight
{
    /// <summary>Whether each voxel is seen, by its number.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="map">The voxels.</param>
    /// <param name="depths">
    /// Depth along the camera's axis at the middle of each pixel, metres, row by row; positive infinity for the sky.
    /// </param>
    /// <exception cref="ArgumentException">There is not a depth for each pixel.</exception>
    public static bool[] Of(Camera camera, VoxelMap map, float[] depths)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(map, nameof(map));
        if (Guard.NotNull(depths, nameof(depths)).Length != camera.Image.PixelCount)
        {
            throw new ArgumentException("There must be a depth for each pixel.", nameof(depths));
        }

        bool[] seen = new bool[map.Kinds.Count];
        SeeSurfaces(camera, map, depths, seen);
        SeeSpace(camera, map, depths, seen);
        return seen;
    }

    private static void SeeSurfaces(Camera camera, VoxelMap map, float[] depths, bool[] seen)
    {
        // The point that a pixel shows at depth d is o + d (f + x r - y u), with the axes right, forward and up of the camera and its ideal
        // normalised coordinates x and y; columns, rows and layers depend on it linearly, so each axis is converted once.
        VoxelGrid grid = map.Grid;
        Axes axes = camera.Pose.Axes;
        Vector3D eye = grid.PlaceOf(camera.Pose.Position);
        Vector3D right = grid.PlaceOf(camera.Pose.Position + axes.Right) - eye;
        Vector3D forward = grid.PlaceOf(camera.Pose.Position + axes.Forward) - eye;
        Vector3D up = grid.PlaceOf(camera.Pose.Position + axes.Up) - eye;
        CameraIntrinsics lens = camera.Intrinsics;
        double reach = (camera.Pose.Position - grid.Frame.Position).Length + grid.Shape.ReachMetres;
        int width = camera.Image.Width;
        Parallel.For(
            0,
            camera.Image.Height,
            row =>
            {
                for (int column = 0; column < width; column++)
                {
                    double depth = depths[(row * width) + column];
                    if (depth > reach)
                    {
                        continue;
                    }

                    Vector2D ideal = lens.Lens.Undistort(new Vector2D((column + 0.5 - lens.Cx) / lens.Fx, (row + 0.5 - lens.Cy) / lens.Fy));
                    int voxel = grid.VoxelAt(eye + (depth * (forward + (ideal.X * right) - (ideal.Y * up))));
                    if (voxel >= 0 && map.KindAt(voxel) is not (VoxelMap.Free or VoxelMap.Enclosed))
                    {
                        seen[voxel] = true;
                    }
                }
            }
        );
    }

    private static void SeeSpace(Camera camera, VoxelMap map, float[] depths, bool[] seen)
    {
        VoxelGrid grid = map.Grid;
        int cells = grid.Shape.Cells;
        double near = camera.Intrinsics.NearClip;
        (int width, int height) = (camera.Image.Width, camera.Image.Height);
        Parallel.For(
            0,
            cells * grid.Shape.Layers,
            line =>
            {
                // The middles of the voxels of a row lie on a line in the camera's frame.
                int first = line * cells;
                Vector3D start = camera.Pose.ToLocal(grid.CentreOf(first));
                Vector3D step = (camera.Pose.ToLocal(grid.CentreOf(first + cells - 1)) - start) / Math.Max(1, cells - 1);
                for (int column = 0; column < cells; column++)
                {
                    Vector3D middle = start + (column * step);
                    if (middle.Y < near || map.KindAt(first + column) != VoxelMap.Free)
                    {
                        continue;
                    }

                    Vector2D pixel = camera.PixelOf(middle);
                    if (pixel.X >= 0 && pixel.Y >= 0 && pixel.X < width && pixel.Y < height)
                    {
                        seen[first + column] = middle.Y <= depths[((int)pixel.Y * width) + (int)pixel.X];
                    }
                }
            }
        );
    }
}
