using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Controllers;

/// <summary>
/// The lane to drive in, from the indicators of both systems. While the car is near a marking, the direction of its lane change
/// distinguishes the lanes on either side; a lane change is over when the car is well within the lane it moved to.
/// </summary>
internal sealed class LaneTarget
{
    private const double UnknownCentre = 0;
    private int _boundFor;
    private double _lastLaneCentre;

    /// <summary>-1 while moving to the lane on the left, 1 to the right, 0 when keeping lane.</summary>
    public int BoundFor => _boundFor;

    public void MoveTo(int side) => _boundFor = side;

    /// <summary>Offset of the target lane's centre, metres to the right of the car; null if the indicators give no lane.</summary>
    public double? Centre(LaneIndicators at)
    {
        if (at.ToMarkingML.IsValid && at.ToMarkingMR.IsValid)
        {
            return InLane(at);
        }

        if (!at.ToMarkingM.IsValid)
        {
            return null;
        }

        double? left = at.ToMarkingL.IsValid ? (at.ToMarkingL.Value + at.ToMarkingM.Value) / 2 : null;
        double? right = at.ToMarkingR.IsValid ? (at.ToMarkingR.Value + at.ToMarkingM.Value) / 2 : null;
        bool goesLeft = _boundFor != 0 ? _boundFor < 0 : _lastLaneCentre < UnknownCentre;
        return goesLeft ? left ?? right : right ?? left;
    }

    private double InLane(LaneIndicators at)
    {
        double own = (at.ToMarkingML.Value + at.ToMarkingMR.Value) / 2;

        // Until the centre of the car's lane jumps by half a lane, the car is still in the lane that it leaves, and the target is the lane
        // beside that.
        if (_boundFor < 0 && at.ToMarkingLL.IsValid && own > _lastLaneCentre - LaneWidth(at) / 2)
        {
            _lastLaneCentre = own;
            return (at.ToMarkingLL.Value + at.ToMarkingML.Value) / 2;
        }

        if (_boundFor > 0 && at.ToMarkingRR.IsValid && own < _lastLaneCentre + LaneWidth(at) / 2)
        {
            _lastLaneCentre = own;
            return (at.ToMarkingRR.Value + at.ToMarkingMR.Value) / 2;
        }

        // The centre of the lane jumped by a lane's width: the car has crossed into the target lane.
        _boundFor = 0;
        _lastLaneCentre = own;
        return own;
    }

    private static double LaneWidth(LaneIndicators at) => Math.Abs(at.ToMarkingMR.Value - at.ToMarkingML.Value);
}
