namespace Harvester.Driving.Controllers;

/// <summary>What a controller does with its lane.</summary>
internal enum LaneManoeuvre
{
    Keep,
    LeaveToLeft,
    ArriveFromRight,
    LeaveToRight,
    ArriveFromLeft,
}
