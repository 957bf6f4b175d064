using Harvester.Geometry.Maps;
using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>Finds vehicles that drive for some time on a lane of the other direction, outside junctions.</summary>
internal sealed class WrongWayWatch : IEventWatch
{
    /// <summary>Times closer than this, seconds, are equal.</summary>
    private const double TimeTolerance = 1e-6;

    private static readonly double Against = Math.Cos(EventRules.WrongWayDegrees * Math.PI / 180);

    private Dictionary<RoadUser, double> _since = [];

    /// <inheritdoc/>
    public void Observe(SceneReading reading, EventBook book)
    {
        var since = new Dictionary<RoadUser, double>();
        foreach (RoadUser user in reading.Roads is null ? [] : reading.Driven)
        {
            if (!IsAgainst(user, reading.Roads!))
            {
                continue;
            }

            double began = _since.TryGetValue(user, out double before) ? before : reading.Seconds;
            since.Add(user, began);
            if (reading.Seconds - began < EventRules.WrongWaySeconds - TimeTolerance)
            {
                continue;
            }

            OpenEvent open = book.FindOrBegin(EventKind.WrongWay, reading.Seconds, user);
            if (open.Hold(reading.Seconds, -user.Now.Speed))
            {
                open.Measures = [new(EventMeasures.Speed, user.Now.Speed)];
            }
        }

        _since = since;
    }

    /// <summary>Whether a road user drives forward on a lane of the other direction, and on no other lane or way.</summary>
    private static bool IsAgainst(RoadUser user, RoadScene roads)
    {
        UserReading now = user.Now;
        if (now.Speed < EventRules.MinWrongWaySpeed || now.Ground.Dot(now.Box.Forward) <= 0)
        {
            return false;
        }

        LaneSpot[] on = [.. roads.SpotsOf(user).Where(static spot => spot.FromLane == 0)];
        return on.Length > 0 && Array.TrueForAll(on, spot => spot.Lane.Junction is null && spot.Direction.Dot(now.Box.Forward) <= Against);
    }
}
