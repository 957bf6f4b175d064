using Harvester.Geometry;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>
/// The corners of an upright box, as in KITTI's development kit: length along x, height against y, width along z, before the rotation about
/// y.
/// </summary>
internal static class KittiCorners
{
    /// <summary>The eight corners in the camera's frame (x right, y down, z forward), metres.</summary>
    public static Vector3D[] Of(Vector3D location, double height, double width, double length, double rotationY)
    {
        (double sin, double cos) = Math.SinCos(rotationY);
        var corners = new List<Vector3D>();
        foreach (double along in (double[])[-length / 2, length / 2])
        {
            foreach (double across in (double[])[-width / 2, width / 2])
            {
                var lower = new Vector3D((cos * along) + (sin * across), 0, (cos * across) - (sin * along));
                corners.Add(location + lower);
                corners.Add(location + lower + new Vector3D(0, -height, 0));
            }
        }

        return [.. corners];
    }
}
