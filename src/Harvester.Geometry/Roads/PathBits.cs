namespace Harvester.Geometry.Roads;

/// <summary>
/// The meaning of the bits with which the game's path files store nodes and links, as documented by public tools. The game's memory has the
/// same bits.
/// </summary>
public static class PathBits
{
    /// <summary>The value of an unspecified median: all four bits set.</summary>
    private const int UnknownMedian = 15;

    /// <summary>Decodes the bytes of a node.</summary>
    /// <param name="flags">The six bytes in order; only the lowest 8 bits of each count.</param>
    /// <exception cref="ArgumentException">There are not exactly six.</exception>
    public static RoadNodeFlags NodeFlags(params int[] flags)
    {
        if (Guard.NotNull(flags, nameof(flags)).Length != 6)
        {
            throw new ArgumentException("A node has six bytes of flags.", nameof(flags));
        }

        return When(flags[0], 8, RoadNodeFlags.OffRoad)
            | When(flags[0], 32, RoadNodeFlags.NoBigVehicles)
            | When(flags[0], 64, RoadNodeFlags.CannotGoRight)
            | When(flags[0], 128, RoadNodeFlags.CannotGoLeft)
            | When(flags[1], 1, RoadNodeFlags.SlipLane)
            | When(flags[1], 2, RoadNodeFlags.IndicateKeepLeft)
            | When(flags[1], 4, RoadNodeFlags.IndicateKeepRight)
            | FlagsOfSpecial((flags[1] >> 3) & 31)
            | When(flags[2], 1, RoadNodeFlags.NoGps)
            | When(flags[2], 4, RoadNodeFlags.Junction)
            | When(flags[2], 32, RoadNodeFlags.Water)
            | When(flags[2], 64, RoadNodeFlags.Highway)
            | When(flags[2], 128, RoadNodeFlags.SwitchedOff)
            | When(flags[3], 1, RoadNodeFlags.Tunnel)
            | When(flags[4], 0x70, RoadNodeFlags.DeadEnd)
            | When(flags[4], 128, RoadNodeFlags.LeftTurnsOnly);
    }

    /// <summary>The speed of traffic at a node, from its last byte.</summary>
    public static RoadSpeed SpeedOf(int flags5) => (RoadSpeed)((flags5 >> 1) & 3);

    /// <summary>The density of traffic at a node, 0 to 15, from its fifth byte.</summary>
    public static int DensityOf(int flags4) => flags4 & 15;

    /// <summary>
    /// The flag of a node's kind, which text files give as a number; <see cref="RoadNodeFlags.None"/> for kinds of unknown meaning.
    /// </summary>
    public static RoadNodeFlags FlagsOfSpecial(int special) =>
        special switch
        {
            2 => RoadNodeFlags.Parking,
            10 => RoadNodeFlags.PedestrianCrossing,
            14 => RoadNodeFlags.PedestrianAssisted,
            15 => RoadNodeFlags.TrafficLight,
            16 => RoadNodeFlags.GiveWay,
            17 => RoadNodeFlags.Caution,
            18 => RoadNodeFlags.PedestrianCrossingWithoutWait,
            19 => RoadNodeFlags.EmergencyOnly,
            20 => RoadNodeFlags.OffRoadJunction,
            _ => RoadNodeFlags.None,
        };

    /// <summary>Decodes the bits that the game's GET_VEHICLE_NODE_PROPERTIES returns.</summary>
    public static RoadNodeFlags FlagsOfProperties(int properties) =>
        When(properties, 1, RoadNodeFlags.OffRoad)
        | When(properties, 4, RoadNodeFlags.NoBigVehicles)
        | When(properties, 8, RoadNodeFlags.SwitchedOff)
        | When(properties, 16, RoadNodeFlags.Tunnel)
        | When(properties, 32, RoadNodeFlags.DeadEnd)
        | When(properties, 64, RoadNodeFlags.Highway)
        | When(properties, 128, RoadNodeFlags.Junction)
        | When(properties, 256, RoadNodeFlags.TrafficLight)
        | When(properties, 512, RoadNodeFlags.GiveWay)
        | When(properties, 1024, RoadNodeFlags.Water)
        | When(properties, 2048, RoadNodeFlags.NoGps);

    /// <summary>Decodes a link stored at its first node.</summary>
    /// <param name="from">Index of the node that stores it.</param>
    /// <param name="to">Index of the node to which it leads.</param>
    /// <param name="bits">Its three bytes of flags as one number, the first byte lowest; higher bits are ignored.</param>
    public static RoadLink Link(int from, int to, int bits)
    {
        int median = (bits >> 12) & 15;
        return new RoadLink(from, to, (bits >> 21) & 7, (bits >> 18) & 7, median == UnknownMedian ? null : median, LinkFlags(bits));
    }

    private static RoadLinkFlags LinkFlags(int bits) =>
        When(bits, 1 << 0, RoadLinkFlags.GpsBothWays)
        | When(bits, 1 << 1, RoadLinkFlags.BlockIfNoLanes)
        | When(bits, 1 << 9, RoadLinkFlags.NarrowRoad)
        | When(bits, 1 << 16, RoadLinkFlags.DontUseForNavigation)
        | When(bits, 1 << 17, RoadLinkFlags.Shortcut);

    private static RoadNodeFlags When(int bits, int mask, RoadNodeFlags flag) => (bits & mask) != 0 ? flag : RoadNodeFlags.None;

    private static RoadLinkFlags When(int bits, int mask, RoadLinkFlags flag) => (bits & mask) != 0 ? flag : RoadLinkFlags.None;
}
