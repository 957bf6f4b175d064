namespace Harvester.Simulation.Traffic;

/// <summary>A vehicle and the ground that it is about to cover.</summary>
/// <param name="Vehicle">The vehicle.</param>
/// <param name="Now">Its current footprint.</param>
/// <param name="Next">Its footprint after the tick.</param>
/// <param name="Further">Its footprint a little farther on, where nothing ahead may be.</param>
internal readonly record struct WayAhead(Vehicle Vehicle, Footprint Now, Footprint Next, Footprint Further)
{
    private readonly double _reach = Next.HalfLength + Next.HalfWidth;

    public bool IsBlockedBy(in Footprint other)
    {
        // Most bodies are far away: rectangles farther apart than this cannot overlap.
        double reach = _reach + other.HalfLength + other.HalfWidth;
        bool mayOverlap =
            Streets.Horizontal.SquaredDistance(Next.Centre, other.Centre) <= reach * reach
            || Streets.Horizontal.SquaredDistance(Further.Centre, other.Centre) <= reach * reach;
        return mayOverlap && (Next.Overlaps(other) || (Further.Overlaps(other) && (other.Centre - Now.Centre).Dot(Now.Forward) > 0));
    }
}
