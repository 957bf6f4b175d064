using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>
/// Moves the ends of borders so that none lies behind the start. In a bend of short roads, the inner edge of one may run back from end to
/// end: it shrinks to <see cref="MinLength"/> at its middle, and the edges of the roads before and after it are drawn there.
/// </summary>
internal static class BorderEnds
{
    /// <summary>The length of a border whose ends would change places, metres.</summary>
    private const double MinLength = 0.2;

    /// <summary>
    /// How often all borders are gone through, since an end that is moved may turn the next border; borders that still disagree then stay
    /// as they are.
    /// </summary>
    private const int MaxRounds = 50;

    /// <summary>Puts the ends in order.</summary>
    /// <param name="borders">The borders.</param>
    /// <param name="places">The places of their ends, which are moved.</param>
    public static void Order(IReadOnlyCollection<LaneBorder> borders, MeetingPoints places)
    {
        bool isMoved = true;
        for (int round = 0; isMoved && round < MaxRounds; round++)
        {
            isMoved = false;
            foreach (LaneBorder border in borders.Where(border => places.GroupOf(border.Start) != places.GroupOf(border.End)))
            {
                (Vector3D start, Vector3D end) = (places.PositionOf(border.Start), places.PositionOf(border.End));
                Vector3D chord = border.Axis[^1] - border.Axis[0];
                Vector3D along = chord * (1 / chord.Length);
                if ((end - start).Dot(along) < MinLength / 2)
                {
                    Vector3D middle = (start + end) * 0.5;
                    places.Move(border.Start, middle - (along * (MinLength / 2)));
                    places.Move(border.End, middle + (along * (MinLength / 2)));
                    isMoved = true;
                }
            }
        }
    }
}
