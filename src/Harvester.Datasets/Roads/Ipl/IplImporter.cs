using System.Globalization;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Roads.Ipl;

/// <summary>
/// Reads paths.ipl: a section "vnod" with 22 values per node and a section "link" with 6 values per link, each closed by "end". The
/// positions are not truncated. The lanes "out" are assumed to run from a link's first node to its second; no public source confirms this.
/// </summary>
internal static class IplImporter
{
    private const int NodeValues = 22;
    private const int LinkValues = 6;

    private static readonly (int Column, RoadNodeFlags Flag)[] NodeFlags =
    [
        (3, RoadNodeFlags.SwitchedOff),
        (4, RoadNodeFlags.Water),
        (10, RoadNodeFlags.Highway),
        (11, RoadNodeFlags.NoGps),
        (12, RoadNodeFlags.Tunnel),
        (14, RoadNodeFlags.CannotGoLeft),
        (15, RoadNodeFlags.LeftTurnsOnly),
        (16, RoadNodeFlags.OffRoad),
        (17, RoadNodeFlags.CannotGoRight),
        (18, RoadNodeFlags.NoBigVehicles),
        (19, RoadNodeFlags.IndicateKeepLeft),
        (20, RoadNodeFlags.IndicateKeepRight),
        (21, RoadNodeFlags.SlipLane),
    ];

    private static readonly RoadLinkFlags[] LinkFlags =
    [
        RoadLinkFlags.NarrowRoad,
        RoadLinkFlags.GpsBothWays,
        RoadLinkFlags.BlockIfNoLanes,
        RoadLinkFlags.Shortcut,
        RoadLinkFlags.DontUseForNavigation,
    ];

    /// <summary>Whether one of the first lines opens a section.</summary>
    public static bool Understands(string head)
    {
        foreach (string line in head.Split('\n'))
        {
            if (line.Trim() is "vnod" or "link")
            {
                return true;
            }
        }

        return false;
    }

    public static RoadImport Import(RoadSource source, LanesIn lanesIn)
    {
        var assembly = new RoadAssembly();
        var links = new List<(int Line, RoadLink Link)>();
        using TextReader reader = source.OpenText();
        var sections = new HashSet<string>(StringComparer.Ordinal);
        string? section = null;
        int number = 0;
        while (reader.ReadLine() is { } text)
        {
            number++;
            string line = text.Trim();
            if (line.Length == 0 || line[0] == '#')
            {
                continue;
            }

            if (section is null)
            {
                section = line;
                if (line is "vnod" or "link")
                {
                    sections.Add(line);
                }
            }
            else if (line == "end")
            {
                section = null;
            }
            else if (section == "vnod")
            {
                assembly.Add(Node(new IplRow(source.Name, number, line, NodeValues), assembly.NodeCount));
            }
            else if (section == "link")
            {
                RoadAssembly.RequireRoom(links.Count);
                links.Add((number, Link(new IplRow(source.Name, number, line, LinkValues), lanesIn)));
            }
        }

        if (section is not null)
        {
            throw new DatasetFormatException($"{source.Name}, line {number}: the file ends within the section {section}.");
        }

        if (!sections.Contains("vnod") || !sections.Contains("link"))
        {
            throw new DatasetFormatException($"{source.Name}, line {number}: the file ends before its sections vnod and link.");
        }

        foreach ((int line, RoadLink link) in links)
        {
            if (Math.Max(link.From, link.To) >= assembly.NodeCount)
            {
                throw new DatasetFormatException(
                    $"{source.Name}, line {line}: the link runs from node {link.From} to node {link.To}; there are {assembly.NodeCount} "
                        + "nodes."
                );
            }

            assembly.Add(link);
        }

        return assembly.Finish("paths.ipl");
    }

    private static RoadNode Node(IplRow row, int index)
    {
        RoadNodeFlags flags = PathBits.FlagsOfSpecial(row.Whole(7, 0, byte.MaxValue));
        foreach ((int column, RoadNodeFlags flag) in NodeFlags)
        {
            flags |= row.Whole(column, 0, 1) != 0 ? flag : RoadNodeFlags.None;
        }

        uint street = (uint)row.Large(9, 0, uint.MaxValue);
        return new RoadNode(
            RoadNode.NoArea,
            index,
            new Vector3D(row.Number(0), row.Number(1), row.Number(2)),
            street == 0 ? "" : "hash_" + street.ToString("X8", CultureInfo.InvariantCulture),
            flags
        )
        {
            Speed = TextRoadFields.Speed(row.Whole(6, 0, 3)),
            Density = TextRoadFields.Density(row.Number(8)),
        };
    }

    private static RoadLink Link(IplRow row, LanesIn lanesIn)
    {
        int bits = row.Whole(5, 0, (1 << LinkFlags.Length) - 1);
        var flags = RoadLinkFlags.None;
        for (int i = 0; i < LinkFlags.Length; i++)
        {
            flags |= (bits & (1 << i)) != 0 ? LinkFlags[i] : RoadLinkFlags.None;
        }

        return new RoadLink(
            row.Whole(0, 0, int.MaxValue),
            row.Whole(1, 0, int.MaxValue),
            row.Whole(lanesIn == LanesIn.Forward ? 3 : 4, 0, TextRoadFields.MaxLanes),
            row.Whole(lanesIn == LanesIn.Forward ? 4 : 3, 0, TextRoadFields.MaxLanes),
            TextRoadFields.Median(row.Whole(2, -TextRoadFields.MaxWidth, TextRoadFields.MaxWidth)),
            flags
        );
    }
}
