using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Grids;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The cells of a bird's-eye map that a camera sees, by the depth of its picture: the ground at the middle of the cell, or some of the
/// vehicle or person that is there.
/// </summary>
internal static class VisibleCells
{
    /// <summary>The ground of a cell is hidden by what is nearer by more than this part of its depth.</summary>
    private const double Tolerance = 0.01;

    /// <summary>The same, metres.</summary>
    private const double ToleranceMetres = 0.1;

    /// <summary>Ground that is farther than the point by more than this factor is not what the pixel shows of it.</summary>
    private const double MaxShare = 2;

    /// <summary>Whether each cell is seen, row by row.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="map">The ground.</param>
    /// <param name="owners">The handle of the vehicle or person in each cell; 0 for the ground.</param>
    /// <param name="truth">What the picture shows.</param>
    public static bool[] Of(Camera camera, GroundMap map, int[] owners, ISurfaceTruth truth)
    {
        (float[] depths, int[] handles) = truth.Surfaces(camera.Image);
        HashSet<int> seen = [.. handles];
        bool[] visible = new bool[owners.Length];
        for (int cell = 0; cell < visible.Length; cell++)
        {
            visible[cell] = owners[cell] != 0 ? seen.Contains(owners[cell]) : IsGroundSeen(camera, depths, map, cell);
        }

        return visible;
    }

    private static bool IsGroundSeen(Camera camera, float[] depths, GroundMap map, int cell)
    {
        double height = map.Heights[cell];
        if (double.IsNaN(height))
        {
            return false;
        }

        Vector2D middle = map.Grid.CentreOf(cell % map.Grid.Cells, cell / map.Grid.Cells);
        var point = new Vector3D(middle.X, middle.Y, height);
        Projection shown = camera.Project(point);
        if (shown.Outcome != ProjectionOutcome.InImage)
        {
            return false;
        }

        // The picture has the depth of the ray through the middle of the pixel, which meets the ground elsewhere than at the point: far
        // ahead by metres. So what counts is the depth at which that ray meets the plane of the ground, n · (o + t r - p) = 0.
        (int column, int row) = ((int)shown.U, (int)shown.V);
        Ray ray = camera.RayThrough(column + 0.5, row + 0.5);
        Vector3D normal = map.NormalAt(cell);
        double above = normal.Dot(camera.Pose.Position - point);
        double falls = -normal.Dot(ray.Direction);
        if (above <= 0)
        {
            return false;
        }

        // A ray that does not meet the plane, or beyond the pixel's share of it, passes over the point.
        double along = falls > 0 ? above / falls * ray.Direction.Dot(camera.Pose.Axes.Forward) : double.PositiveInfinity;
        double expected = Math.Min(along, MaxShare * shown.Depth);
        return depths[(row * camera.Image.Width) + column] >= expected - ToleranceMetres - (Tolerance * expected);
    }
}
