namespace Harvester.Simulation.World;

/// <summary>A line painted along a road.</summary>
/// <param name="Offset">Metres to the right of the road's line.</param>
/// <param name="Kind">How it is painted.</param>
internal readonly record struct Marking(double Offset, MarkingKind Kind)
{
    public bool IsDashed => Kind is MarkingKind.LaneDashed or MarkingKind.CentreDashed;

    public bool IsYellow => Kind is MarkingKind.Centre or MarkingKind.CentreDashed;
}
