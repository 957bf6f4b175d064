using Harvester.Geometry;
using Harvester.Geometry.Calibration;

namespace Harvester.Capture.Calibration;

/// <summary>Assigns the spots of an image to markers.</summary>
internal static class MarkerMatcher
{
    // Less than half the grid's spacing, so that a spot lies within reach of one marker only.
    private const double ReachInSpacings = 0.49;

    /// <summary>The markers that are visible: each with the spot nearest to where it is expected, if one is within reach.</summary>
    public static IReadOnlyList<Sighting> Match(MarkerPlan plan, Pose camera, IReadOnlyList<MarkerSpot> spots)
    {
        var sightings = new List<Sighting>();
        foreach (PlannedMarker marker in plan.Markers)
        {
            double best = ReachInSpacings * plan.SpacingPixels;
            Vector2D? seen = null;
            foreach (Vector2D centre in spots.Select(spot => spot.Centre))
            {
                double distance = (centre - marker.ExpectedPixel).Length;
                if (distance < best)
                {
                    best = distance;
                    seen = centre;
                }
            }

            if (seen is { } pixel)
            {
                sightings.Add(new Sighting(camera, marker.CentreOfImage(camera), pixel));
            }
        }

        return sightings;
    }
}
