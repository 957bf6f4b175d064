namespace Harvester.Geometry.Paint;

/// <summary>The paint measured on one link.</summary>
/// <param name="Link">Index of the link in its network.</param>
/// <param name="SeenFrom">First station at which the carriageway was seen, metres from the link's start.</param>
/// <param name="SeenTo">Last station at which it was seen; greater than <paramref name="SeenFrom"/>. Between the two, paint that is not
/// in the list is probably absent; elsewhere it is unknown.</param>
/// <param name="Lines">The lines, by station and then offset; empty if none was found.</param>
public sealed record LinkPaint(int Link, double SeenFrom, double SeenTo, IReadOnlyList<LinePaint> Lines);
