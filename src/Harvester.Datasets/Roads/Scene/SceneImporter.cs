using System.Xml.Linq;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Roads.Scene;

/// <summary>
/// Reads paths.xml, the scene from which the game's paths were made, with objects of the classes vehiclenode and vehiclelink. A link refers
/// to its two nodes by their guids. The positions are not truncated. Missing attributes have the defaults of the scene.
/// </summary>
internal static class SceneImporter
{
    /// <summary>Largest total length of names and values; those of the whole game have about 40 million characters.</summary>
    private const long MaxHeldCharacters = 64 << 20;

    private const int DefaultLanes = 1;
    private const int DefaultSpeed = 1;

    private static readonly (string Name, RoadNodeFlags Flag)[] NodeFlags =
    [
        ("Disabled", RoadNodeFlags.SwitchedOff),
        ("Water", RoadNodeFlags.Water),
        ("Highway", RoadNodeFlags.Highway),
        ("NoGps", RoadNodeFlags.NoGps),
        ("Tunnel", RoadNodeFlags.Tunnel),
        ("Cannot Go Left", RoadNodeFlags.CannotGoLeft),
        ("Left Turns Only", RoadNodeFlags.LeftTurnsOnly),
        ("Off Road", RoadNodeFlags.OffRoad),
        ("Cannot Go Right", RoadNodeFlags.CannotGoRight),
        ("No Big Vehicles", RoadNodeFlags.NoBigVehicles),
        ("Indicate Keep Left", RoadNodeFlags.IndicateKeepLeft),
        ("Indicate Keep Right", RoadNodeFlags.IndicateKeepRight),
        ("Slip Lane", RoadNodeFlags.SlipLane),
    ];

    private static readonly (string Name, RoadLinkFlags Flag)[] LinkFlags =
    [
        ("Narrowroad", RoadLinkFlags.NarrowRoad),
        ("GpsBothWays", RoadLinkFlags.GpsBothWays),
        ("Block If No Lanes", RoadLinkFlags.BlockIfNoLanes),
        ("Shortcut", RoadLinkFlags.Shortcut),
        ("Dont Use For Navigation", RoadLinkFlags.DontUseForNavigation),
    ];

    public static RoadImport Import(RoadSource source, LanesIn lanesIn)
    {
        var assembly = new RoadAssembly();
        var indices = new Dictionary<string, int>(StringComparer.Ordinal);
        var links = new List<SceneObject>();
        long held = 0;
        foreach (XElement element in RoadXml.Elements(source, "object"))
        {
            switch (element.Attribute("class")?.Value)
            {
                case "vehiclenode":
                    string guid = element.Attribute("guid")?.Value ?? throw RoadXml.Wrong(source, element, "a vehiclenode has no guid.");
                    if (!indices.TryAdd(guid, assembly.NodeCount))
                    {
                        throw RoadXml.Wrong(source, element, $"the guid {guid} occurs twice.");
                    }

                    assembly.Add(Node(source, element, assembly.NodeCount));
                    break;
                case "vehiclelink":
                    held += CharactersOf(element);
                    links.Add(
                        held <= MaxHeldCharacters
                            ? new SceneObject(source, element)
                            : throw RoadXml.Wrong(
                                source,
                                element,
                                FormattableString.Invariant(
                                    $"the links up to here have more than {MaxHeldCharacters} characters, the limit."
                                )
                            )
                    );
                    break;
            }
        }

        foreach (SceneObject link in links)
        {
            IReadOnlyList<string> ends = link.References;
            if (ends.Count != 2)
            {
                throw link.Wrong($"a vehiclelink must refer to two nodes, not {ends.Count}.");
            }

            assembly.Add(Link(link, Index(link, indices, ends[0]), Index(link, indices, ends[1]), lanesIn));
        }

        return assembly.NodeCount > 0
            ? assembly.Finish("paths.xml")
            : throw new DatasetFormatException(
                $"{source.Name}: the XML is neither a NodeDictionary nor a scene with objects of the class vehiclenode."
            );
    }

    private static long CharactersOf(XElement element) =>
        element
            .DescendantsAndSelf()
            .Sum(part =>
                part.Name.LocalName.Length
                + part.Attributes().Sum(attribute => (long)attribute.Name.LocalName.Length + attribute.Value.Length)
            );

    private static int Index(SceneObject link, Dictionary<string, int> indices, string guid) =>
        indices.TryGetValue(guid, out int index) ? index : throw link.Wrong($"the link refers to {guid}, which is not a node of the file.");

    private static RoadNode Node(RoadSource source, XElement element, int index)
    {
        var node = new SceneObject(source, element);
        XElement position = element.Child(source, "transform").Child(source, "object").Child(source, "position");
        RoadNodeFlags flags = NodeFlags.Where(flag => node.IsTrue(flag.Name)).Aggregate(RoadNodeFlags.None, (sum, flag) => sum | flag.Flag);
        return new RoadNode(
            RoadNode.NoArea,
            index,
            new Vector3D(position.Number(source, "x"), position.Number(source, "y"), position.Number(source, "z")),
            Street(node.Text("Streetname")),
            flags | PathBits.FlagsOfSpecial(node.Whole("Special", 0, 0, byte.MaxValue))
        )
        {
            Speed = TextRoadFields.Speed(node.Whole("Speed", DefaultSpeed, 0, 3)),
            Density = node.Number("Density") is { } density ? TextRoadFields.Density(density) : null,
        };
    }

    private static string Street(string? text) => text is null or "0" ? "" : text;

    private static RoadLink Link(SceneObject link, int from, int to, LanesIn lanesIn) =>
        new(
            from,
            to,
            link.Whole(lanesIn == LanesIn.Forward ? "Lanes In" : "Lanes Out", DefaultLanes, 0, TextRoadFields.MaxLanes),
            link.Whole(lanesIn == LanesIn.Forward ? "Lanes Out" : "Lanes In", DefaultLanes, 0, TextRoadFields.MaxLanes),
            TextRoadFields.Median(link.Whole("Width", 0, -TextRoadFields.MaxWidth, TextRoadFields.MaxWidth)),
            LinkFlags.Where(flag => link.IsTrue(flag.Name)).Aggregate(RoadLinkFlags.None, (sum, flag) => sum | flag.Flag)
        );
}
