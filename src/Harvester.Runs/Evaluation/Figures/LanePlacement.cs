namespace Harvester.Runs.Evaluation.Figures;

/// <summary>A car's place across the lanes of its direction.</summary>
/// <param name="Road">Number of the road.</param>
/// <param name="Lane">Index of the lane from the left, from 0; null outside the lanes of its direction.</param>
/// <param name="Lanes">Number of lanes in its direction.</param>
/// <param name="LaneWidth">Lane width, metres.</param>
/// <param name="RightOfCentre">Distance to the right of the lane centre, metres.</param>
/// <param name="HalfBreadth">Half of the car's extent across the road at its current heading, metres.</param>
public sealed record LanePlacement(int Road, int? Lane, int Lanes, double LaneWidth, double RightOfCentre, double HalfBreadth)
{
    /// <summary>Whether a part of the car is left of its lane.</summary>
    public bool IsOverLeft => HalfBreadth - RightOfCentre > LaneWidth / 2;

    /// <summary>Whether a part of the car is right of its lane.</summary>
    public bool IsOverRight => HalfBreadth + RightOfCentre > LaneWidth / 2;

    /// <summary>Whether a part of the car is beyond the lanes of its direction.</summary>
    public bool IsBeyondLanes => Lane is null || (IsOverLeft && Lane == 0) || (IsOverRight && Lane == Lanes - 1);
}
