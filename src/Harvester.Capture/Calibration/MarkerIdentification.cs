using Harvester.Geometry;
using Harvester.Geometry.Calibration;

namespace Harvester.Capture.Calibration;

/// <summary>Identifies markers by the images that show them, wherever they appear.</summary>
/// <param name="reachPixels">Maximum distance of spots in different images that count as one; less than the distance of markers.</param>
internal sealed class MarkerIdentification(double reachPixels)
{
    private readonly List<SeenSpot> _spots = [];

    /// <summary>Number of spots that are not a marker, by the images that show them.</summary>
    public int UnknownCount => _spots.Count(spot => spot.Marker < 0);

    /// <summary>Adds the spots of an image.</summary>
    public void Add(int picture, IReadOnlyList<MarkerSpot> spots)
    {
        foreach (MarkerSpot spot in spots)
        {
            if (_spots.Find(seen => (seen.Centre - spot.Centre).Length < reachPixels) is { } known)
            {
                known.Add(picture, spot.Centre);
            }
            else
            {
                _spots.Add(new SeenSpot(picture, spot.Centre));
            }
        }
    }

    /// <summary>The markers that are visible, except those that two spots could be.</summary>
    public IReadOnlyList<Sighting> SightingsOf(MarkerPlan plan, Pose camera) =>
        [
            .. _spots
                .GroupBy(spot => spot.Marker)
                .Where(group => group.Key >= 0 && group.Key < plan.Markers.Count && group.Count() == 1)
                .Select(group => new Sighting(camera, plan.Markers[group.Key].CentreOfImage(camera), group.First().Centre)),
        ];

    /// <summary>A spot, and the images that show it.</summary>
    private sealed class SeenSpot(int picture, Vector2D centre)
    {
        private readonly List<int> _pictures = [picture];
        private Vector2D _sum = centre;

        public Vector2D Centre => _sum * (1.0 / _pictures.Count);

        public int Marker => MarkerCode.MarkerIn(_pictures);

        public void Add(int picture, Vector2D centre)
        {
            _pictures.Add(picture);
            _sum += centre;
        }
    }
}
