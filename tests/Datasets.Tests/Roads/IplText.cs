using System.Globalization;
using System.Text;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>Writes the text of paths.ipl.</summary>
internal static class IplText
{
    public static string Of(RoadNetwork network)
    {
        var text = new StringBuilder("version\nend\nvnod\n");
        foreach (RoadNode node in network.Nodes)
        {
            int Bit(RoadNodeFlags flag) => (node.Flags & flag) != 0 ? 1 : 0;
            uint street =
                node.Street.Length == 0 ? 0 : uint.Parse(node.Street.AsSpan(5), NumberStyles.HexNumber, CultureInfo.InvariantCulture);
            text.Append(
                CultureInfo.InvariantCulture,
                $"{node.Position.X}, {node.Position.Y}, {node.Position.Z}, {Bit(RoadNodeFlags.SwitchedOff)}, {Bit(RoadNodeFlags.Water)}, "
                    + $"0, {(int)node.Speed!}, {Special(node.Flags)}, "
            );
            text.Append(
                CultureInfo.InvariantCulture,
                $"{node.Density / 15.0:0.######}, {street}, {Bit(RoadNodeFlags.Highway)}, {Bit(RoadNodeFlags.NoGps)}, "
                    + $"{Bit(RoadNodeFlags.Tunnel)}, 0, {Bit(RoadNodeFlags.CannotGoLeft)}, "
            );
            text.Append(
                CultureInfo.InvariantCulture,
                $"{Bit(RoadNodeFlags.LeftTurnsOnly)}, {Bit(RoadNodeFlags.OffRoad)}, {Bit(RoadNodeFlags.CannotGoRight)}, "
                    + $"{Bit(RoadNodeFlags.NoBigVehicles)}, "
            );
            text.Append(
                CultureInfo.InvariantCulture,
                $"{Bit(RoadNodeFlags.IndicateKeepLeft)}, {Bit(RoadNodeFlags.IndicateKeepRight)}, {Bit(RoadNodeFlags.SlipLane)}\n"
            );
        }

        text.Append("end\nlink\n");
        foreach (RoadLink link in network.Links)
        {
            int Bit(RoadLinkFlags flag, int value) => (link.Flags & flag) != 0 ? value : 0;
            int flags =
                Bit(RoadLinkFlags.NarrowRoad, 1)
                + Bit(RoadLinkFlags.GpsBothWays, 2)
                + Bit(RoadLinkFlags.BlockIfNoLanes, 4)
                + Bit(RoadLinkFlags.Shortcut, 8)
                + Bit(RoadLinkFlags.DontUseForNavigation, 16);
            text.Append(
                CultureInfo.InvariantCulture,
                $"{link.From}, {link.To}, {link.MedianWidth ?? -1}, {link.LanesForward}, {link.LanesBackward}, {flags}\n"
            );
        }

        return text.Append("end\n").ToString();
    }

    internal static int Special(RoadNodeFlags flags) =>
        flags.HasFlag(RoadNodeFlags.Parking) ? 2
        : flags.HasFlag(RoadNodeFlags.PedestrianCrossing) ? 10
        : flags.HasFlag(RoadNodeFlags.PedestrianAssisted) ? 14
        : flags.HasFlag(RoadNodeFlags.TrafficLight) ? 15
        : flags.HasFlag(RoadNodeFlags.GiveWay) ? 16
        : flags.HasFlag(RoadNodeFlags.Caution) ? 17
        : flags.HasFlag(RoadNodeFlags.PedestrianCrossingWithoutWait) ? 18
        : flags.HasFlag(RoadNodeFlags.EmergencyOnly) ? 19
        : flags.HasFlag(RoadNodeFlags.OffRoadJunction) ? 20
        : 0;
}
