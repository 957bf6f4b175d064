using System.Globalization;
using System.Text;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>Writes the text of paths.xml; what has the default value is left out, as the game's own file does.</summary>
internal static class SceneText
{
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

    public static string Of(RoadNetwork network)
    {
        var text = new StringBuilder("<?xml version=\"1.0\"?>\n<scene>\n<objects>\n<object class=\"propagroup\" guid=\"{x}\" />\n");
        for (int i = 0; i < network.Nodes.Count; i++)
        {
            RoadNode node = network.Nodes[i];
            text.Append(
                CultureInfo.InvariantCulture,
                $"<object class=\"vehiclenode\" guid=\"{{{i}}}\">\n<transform><object><position x=\"{node.Position.X}\" "
                    + $"y=\"{node.Position.Y}\" z=\"{node.Position.Z}\" /></object></transform>\n<attributes>\n"
            );
            Attribute(text, "Speed", (int)node.Speed!, 1);
            Attribute(text, "Special", IplText.Special(node.Flags), 0);
            text.Append(CultureInfo.InvariantCulture, $"<attribute name=\"Density\" value=\"{node.Density / 15.0:0.######}\" />\n");
            if (node.Street.Length > 0)
            {
                text.Append(CultureInfo.InvariantCulture, $"<attribute name=\"Streetname\" value=\"{node.Street}\" />\n");
            }

            Flags(text, NodeFlags.Where(flag => node.Flags.HasFlag(flag.Flag)).Select(flag => flag.Name));
            text.Append("</attributes>\n</object>\n");
        }

        foreach (RoadLink link in network.Links)
        {
            text.Append("<object class=\"vehiclelink\" guid=\"{l}\">\n<transform />\n<attributes>\n");
            Attribute(text, "Width", (int)(link.MedianWidth ?? -1), 0);
            Attribute(text, "Lanes In", link.LanesForward, 1);
            Attribute(text, "Lanes Out", link.LanesBackward, 1);
            Flags(text, LinkFlags.Where(flag => link.Flags.HasFlag(flag.Flag)).Select(flag => flag.Name));
            text.Append(
                CultureInfo.InvariantCulture,
                $"</attributes>\n<children />\n<references><ref guid=\"{{{link.From}}}\" /><ref guid=\"{{{link.To}}}\" /></references>\n"
                    + $"</object>\n"
            );
        }

        return text.Append("</objects>\n</scene>\n").ToString();
    }

    private static void Attribute(StringBuilder text, string name, int value, int fallback)
    {
        if (value != fallback)
        {
            text.Append(CultureInfo.InvariantCulture, $"<attribute name=\"{name}\" value=\"{value}\" />\n");
        }
    }

    private static void Flags(StringBuilder text, IEnumerable<string> names)
    {
        foreach (string name in names)
        {
            text.Append(CultureInfo.InvariantCulture, $"<attribute name=\"{name}\" value=\"true\" />\n");
        }
    }
}
