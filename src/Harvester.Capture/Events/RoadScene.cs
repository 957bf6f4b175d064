using Harvester.Geometry.Maps;

namespace Harvester.Capture.Events;

/// <summary>The roads around the ego at one reading.</summary>
/// <param name="map">The lanes.</param>
/// <param name="lines">The stop lines with a light or a stop sign.</param>
internal sealed class RoadScene(LaneNetwork map, IReadOnlyList<StopLine> lines)
{
    private static readonly double MinAlong = Math.Cos(EventRules.LaneDegrees * Math.PI / 180);

    private readonly Dictionary<RoadUser, IReadOnlyList<LaneSpot>> _spots = [];

    public IReadOnlyList<StopLine> Lines => lines;

    /// <summary>Where the middle of a road user lies on lanes, and beside those whose shoulder it may be on.</summary>
    public IReadOnlyList<LaneSpot> SpotsOf(RoadUser user)
    {
        if (!_spots.TryGetValue(user, out IReadOnlyList<LaneSpot>? spots))
        {
            _spots.Add(user, spots = map.Index.SpotsAt(user.Now.Foot, EventRules.ShoulderMetres));
        }

        return spots;
    }

    /// <summary>Distance of a road user's middle from the nearest lane, metres; null if none is near.</summary>
    public double? FromRoad(RoadUser user)
    {
        IReadOnlyList<LaneSpot> spots = map.Index.SpotsAt(user.Now.Foot, EventRules.BesideMetres);
        return spots.Count > 0 ? spots.Min(static spot => spot.FromLane) : null;
    }

    /// <summary>The lane of a road, outside junctions, on which a road user drives; null if there is none.</summary>
    public LaneSpot? LaneOf(RoadUser user)
    {
        LaneSpot? best = null;
        foreach (LaneSpot spot in SpotsOf(user))
        {
            if (spot.FromLane > 0)
            {
                continue;
            }

            if (spot.Lane.Junction is not null)
            {
                return null;
            }

            // Lanes of one road share only their edges; of those on both sides of an edge, the one whose middle is nearer.
            if (
                spot.Direction.Dot(user.Now.Box.Forward) >= MinAlong
                && (best is not { } other || Math.Abs(spot.Right) < Math.Abs(other.Right))
            )
            {
                best = spot;
            }
        }

        return best;
    }
}
