namespace Harvester.Evaluation.Figures;

/// <summary>A car across the lanes of its direction.</summary>
/// <param name="Road">Number of the road.</param>
/// <param name="Lane">Its lane from the left, from 0; null beside the lanes of its direction.</param>
/// <param name="Lanes">Lanes of its direction.</param>
/// <param name="LaneWidth">Metres.</param>
/// <param name="RightOfCentre">Metres to the right of the middle of its lane.</param>
/// <param name="HalfBreadth">Half of what the car takes up across the road, turned as it is, metres.</param>
public sealed record LanePlacement(int Road, int? Lane, int Lanes, double LaneWidth, double RightOfCentre, double HalfBreadth)
{
    /// <summary>Whether a part of the car is left of its lane.</summary>
    public bool IsOverLeft => HalfBreadth - RightOfCentre > LaneWidth / 2;

    /// <summary>Whether a part of the car is right of its lane.</summary>
    public bool IsOverRight => HalfBreadth + RightOfCentre > LaneWidth / 2;

    /// <summary>Whether a part of the car is beyond the lanes of its direction.</summary>
    public bool IsBeyondLanes => Lane is null || (IsOverLeft && Lane == 0) || (IsOverRight && Lane == Lanes - 1);
}
