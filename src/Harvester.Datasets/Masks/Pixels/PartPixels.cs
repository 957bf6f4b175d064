using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Datasets.Masks.Pixels;

/// <summary>
/// Gives faces and heads their own pixels, which masks assign to their whole objects: a pixel of the whole object inside the silhouette of
/// a part's cuboid belongs to the part; of overlapping parts, to the nearest.
/// </summary>
internal static class PartPixels
{
    /// <summary>The mask with separate pixels for parts.</summary>
    /// <param name="mask">The mask of the session.</param>
    /// <param name="frame">The label of its frame.</param>
    public static InstanceMap Divide(InstanceMap mask, FrameLabel frame)
    {
        ObjectLabel[] parts = [.. frame.Objects.Where(label => label.Parent is not null).OrderByDescending(label => label.DistanceMetres)];
        if (parts.Length == 0)
        {
            return mask;
        }

        var divided = new InstanceMap(mask.Image);
        mask.Ids.CopyTo(divided.Ids, 0);
        Camera camera = LabelCamera.Of(frame.Camera);
        foreach (ObjectLabel part in parts)
        {
            foreach ((int column, int row) in PixelsWithin(part.Box2D, mask.Image))
            {
                if (mask[column, row] == part.Parent && IsCovered(part.Box3D, camera, column, row))
                {
                    divided[column, row] = (ushort)part.Id;
                }
            }
        }

        return divided;
    }

    private static IEnumerable<(int Column, int Row)> PixelsWithin(Box2D box, ImageSize image) =>
        from row in Between(box.YMin, box.YMax, image.Height)
        from column in Between(box.XMin, box.XMax, image.Width)
        select (column, row);

    private static IEnumerable<int> Between(double from, double to, int size)
    {
        int first = Math.Max(0, (int)Math.Floor(from));
        return Enumerable.Range(first, Math.Max(0, Math.Min(size, (int)Math.Ceiling(to)) - first));
    }

    private static bool IsCovered(Cuboid cuboid, Camera camera, int column, int row) =>
        cuboid.Intersect(camera.RayThrough(column + 0.5, row + 0.5)) is not null;
}
