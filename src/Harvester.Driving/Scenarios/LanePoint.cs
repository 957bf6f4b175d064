using Harvester.Geometry.Maps;

namespace Harvester.Driving.Scenarios;

/// <summary>A place beside the middle of a lane.</summary>
/// <param name="Lane">The lane.</param>
/// <param name="Along">Metres from its start to the nearest point of its middle.</param>
/// <param name="Right">Metres to the right of that point, in the lane's direction.</param>
internal readonly record struct LanePoint(MapLane Lane, double Along, double Right)
{
    /// <summary>The lane's width there, metres.</summary>
    public double Width => Lane.StartWidth + ((Lane.EndWidth - Lane.StartWidth) * Math.Max(0, Math.Min(1, Along / Lane.Length)));

    /// <summary>The place beside a lane.</summary>
    public static LanePoint Of(MapLane lane, Geometry.Vector3D place)
    {
        (double at, double right) = new LaneTrack(lane.Centre).Locate(place);
        return new LanePoint(lane, at, right);
    }
}
