using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>The asphalt of all roads as it is drawn.</summary>
internal sealed class Asphalt(StreetIndex index, AsphaltHeights heights)
{
    /// <summary>Maximum height difference of roads on one level, metres; farther ones are on another bridge.</summary>
    private const double SameLevel = 2.5;

    /// <summary>Minimum height above another road's asphalt for something to be visible with certainty, metres.</summary>
    private const double MinAbove = 0.005;

    private readonly Dictionary<Road, RoadFacets> _facets = [];

    /// <summary>The asphalt of a road.</summary>
    public RoadFacets Of(Road road) =>
        _facets.TryGetValue(road, out RoadFacets? facets) ? facets : _facets[road] = new RoadFacets(road, heights);

    /// <summary>Whether a point of a road is on another's carriageway, or would be buried in another's asphalt at a given height.</summary>
    public bool IsAnothers(Road road, double distance, double rightOffset, double above)
    {
        Vector3D place = Of(road).At(distance, rightOffset) + (Horizontal.Up * above);
        return index
            .PlacesAt(place, except: road, beside: Road.WidestShoulder)
            .Any(other =>
                Math.Abs(other.Height) < SameLevel
                && (
                    other.IsOnCarriageway(0)
                    || (
                        other.IsOnCarriageway(other.Road.Shoulder)
                        && Of(other.Road).At(other.Distance, other.RightOffset).Z + MinAbove > place.Z
                    )
                )
            );
    }
}
