namespace Harvester.Simulation.Streets;

/// <summary>A road at a station, and the ground below it.</summary>
/// <param name="Distance">Metres from the road's start.</param>
/// <param name="Left">Its left edge.</param>
/// <param name="Right">Its right edge.</param>
/// <param name="Gap">Depth of the ground below the road's line, metres.</param>
internal readonly record struct RoadSection(double Distance, StreetEdge Left, StreetEdge Right, double Gap)
{
    /// <summary>Depth of the highest ground below it, metres.</summary>
    public double MinGap => Math.Min(Gap, Math.Min(Left.Gap, Right.Gap));

    /// <summary>Depth of the lowest ground below it, metres.</summary>
    public double MaxGap => Math.Max(Gap, Math.Max(Left.Gap, Right.Gap));
}
