using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Depth;

namespace Harvester.Capture.Labelling;

/// <summary>Enters the points of LiDARs into the measured depths of a view.</summary>
internal static class SweptDepth
{
    /// <summary>
    /// A point is seen by the camera too if its depth is that of the completed map, by its estimated error and this fraction: a ray may
    /// pass anywhere through its pixel.
    /// </summary>
    private const double ToleranceFraction = 0.01;

    /// <summary>Adds the points that the view sees and that lie in pixels without a measured depth.</summary>
    public static void Add(FrameDraft view, IEnumerable<Vector3D> points)
    {
        if (view.Part<DepthMaps>() is not { Estimate: { } estimate } maps)
        {
            return;
        }

        foreach (Vector3D point in points)
        {
            Projection seen = view.Camera.Project(point);
            if (seen.Outcome != ProjectionOutcome.InImage)
            {
                continue;
            }

            int at = ((int)seen.V * maps.Sparse.Image.Width) + (int)seen.U;
            if (
                maps.Sparse.Ids[at] == 0
                && Math.Abs(seen.Depth - estimate.Metres[at]) <= estimate.ErrorMetres[at] + (ToleranceFraction * seen.Depth)
            )
            {
                maps.Sparse.Ids[at] = DepthUnits.OfDepth(seen.Depth);
            }
        }
    }
}
