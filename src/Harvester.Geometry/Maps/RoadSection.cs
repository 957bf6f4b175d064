namespace Harvester.Geometry.Maps;

/// <summary>The lanes across a road at a station; between two sections, edges run straight beside the road's line.</summary>
/// <param name="Station">Metres along the road's line from its start.</param>
/// <param name="ForwardEdges">Offsets of the edges of the lanes from start to end, metres to the right of the line, from the left edge of
/// the leftmost lane to the right edge of the rightmost; empty without lanes.</param>
/// <param name="BackwardEdges">The same for the lanes from end to start: metres to the right of the line as seen from its end to its
/// start.</param>
public sealed record RoadSection(double Station, IReadOnlyList<double> ForwardEdges, IReadOnlyList<double> BackwardEdges)
{
    /// <summary>The edges of one direction.</summary>
    public IReadOnlyList<double> Edges(bool isForward) => isForward ? ForwardEdges : BackwardEdges;
}
