namespace Harvester.Geometry.Roads;

/// <summary>
/// The lanes of one direction along a link, as lines painted on it show them: cross sections at stations, between which the edges are
/// straight. Immutable.
/// </summary>
public sealed class MeasuredLanes
{
    private readonly (double Station, MeasuredSection Section)[] _sections;

    /// <summary>Creates the lanes of a direction.</summary>
    /// <param name="sections">Sections with as many lanes each, by their stations, metres along the link's curve from its start, which
    /// increase; at least one.</param>
    /// <exception cref="ArgumentException">There is no section, stations do not increase, or the number of lanes changes.</exception>
    public MeasuredLanes(IReadOnlyList<(double Station, MeasuredSection Section)> sections)
    {
        _sections = [.. Guard.NotNull(sections, nameof(sections))];
        if (_sections.Length == 0)
        {
            throw new ArgumentException("There must be at least one section.", nameof(sections));
        }

        for (int i = 1; i < _sections.Length; i++)
        {
            if (
                !(_sections[i].Station > _sections[i - 1].Station)
                || _sections[i].Section.Section.LaneCount != _sections[0].Section.Section.LaneCount
            )
            {
                throw new ArgumentException("Stations must increase, and all sections must have as many lanes.", nameof(sections));
            }
        }

        RightEdge = _sections.Max(static place => place.Section.LeftEdge + place.Section.Section.Width);
    }

    /// <summary>Largest offset of the right edge of the rightmost lane, metres to the right of the link's line in this direction.</summary>
    public double RightEdge { get; }

    /// <summary>The stations of the sections, metres along the link's curve from its start, ascending.</summary>
    internal IEnumerable<double> Stations => _sections.Select(static place => place.Station);

    /// <summary>The section at a station; before the first and behind the last one, these.</summary>
    /// <param name="station">Metres along the link's curve from its start.</param>
    public MeasuredSection At(double station)
    {
        int next = Array.FindIndex(_sections, place => place.Station >= station);
        if (next <= 0)
        {
            return _sections[next < 0 ? _sections.Length - 1 : 0].Section;
        }

        // With t = (s - s0) / (s1 - s0), an edge is at e0 + t (e1 - e0); so are the widths between edges.
        (double from, MeasuredSection before) = _sections[next - 1];
        (double to, MeasuredSection after) = _sections[next];
        double part = (station - from) / (to - from);
        double Between(double a, double b) => a + (part * (b - a));
        double[] widths =
        [
            .. Enumerable
                .Range(0, before.Section.LaneCount)
                .Select(lane => Between(before.Section.WidthOf(lane), after.Section.WidthOf(lane))),
        ];
        return new MeasuredSection(Between(before.LeftEdge, after.LeftEdge), new LaneSection(widths), before.IsWhole && after.IsWhole);
    }
}
