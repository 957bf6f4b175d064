using Harvester.Geometry.Motion;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Datasets.Validation;

/// <summary>Checks the maps of dense motion of a frame: their numbers are those of docs/flow.md and agree with each other.</summary>
internal static class FlowCheck
{
    private const FlowFlags Reasons = FlowFlags.Valid | FlowFlags.Person | FlowFlags.Unknown;
    private const FlowFlags Known = (FlowFlags)127;

    /// <summary>What is wrong with the label; null for nothing.</summary>
    public static string? ProblemOf(FlowLabel flow, FrameLabel frame) =>
        flow.From < 0 || flow.From >= frame.Frame ? $"flow is from frame {flow.From}, which is not before it." : null;

    /// <summary>What is wrong with the maps, one line each.</summary>
    /// <param name="maps">Their names.</param>
    /// <param name="pathOf">The path of a file of the session.</param>
    /// <exception cref="Harvester.Sessions.Reading.Files.DatasetFormatException">A map cannot be read.</exception>
    public static IEnumerable<string> Problems(FlowFiles maps, Func<string, string> pathOf)
    {
        foreach ((string flow, string flags, string? motion) in Pairs(maps))
        {
            ushort[] vectors = PngDecoder.ReadDeepColour(pathOf(flow));
            InstanceMap known = PngDecoder.ReadLabelMap(pathOf(flags));
            ushort[]? moved = motion is null ? null : PngDecoder.ReadDeepColour(pathOf(motion));
            if (FirstOf(known, at => !IsMeaningful((FlowFlags)known.Ids[at])) is { } meaningless)
            {
                yield return $"map of flow '{flags}' has the number {known.Ids[meaningless]}, whose flags exclude each other.";
            }

            if (FirstOf(known, at => !Agrees(vectors.AsSpan(3 * at, 3), (FlowFlags)known.Ids[at])) is { } wrong)
            {
                yield return $"map of flow '{flow}' and '{flags}' disagree on {PlaceOf(known, wrong)}: the flags say where a flow is.";
            }

            if (moved is not null && FirstOf(known, at => !Fits(moved.AsSpan(3 * at, 3), (FlowFlags)known.Ids[at])) is { } bad)
            {
                yield return $"map of flow '{motion}' and '{flags}' disagree on {PlaceOf(known, bad)}: only a known surface has a motion.";
            }
        }
    }

    private static IEnumerable<(string Flow, string Flags, string? Motion)> Pairs(FlowFiles maps) =>
        [(maps.Backward, maps.BackwardFlags, maps.Motion), (maps.Forward, maps.ForwardFlags, null)];

    private static int? FirstOf(InstanceMap map, Func<int, bool> isIt)
    {
        for (int at = 0; at < map.Ids.Length; at++)
        {
            if (isIt(at))
            {
                return at;
            }
        }

        return null;
    }

    private static string PlaceOf(InstanceMap map, int at) =>
        FormattableString.Invariant($"column {at % map.Image.Width}, row {at / map.Image.Width}");

    /// <summary>
    /// One reason at most, and without any the flow is too long; a covered point is in the picture, and what is seen at infinity stands.
    /// </summary>
    private static bool IsMeaningful(FlowFlags flags)
    {
        FlowFlags reason = flags & Reasons;
        bool hasFlow = reason == FlowFlags.Valid;
        return (flags & ~Known) == 0
            && (
                reason is FlowFlags.Valid or FlowFlags.Person or FlowFlags.Unknown
                || (reason == 0 && flags.HasFlag(FlowFlags.LeavesPicture))
            )
            && (reason is not (FlowFlags.Person or FlowFlags.Unknown) || flags == reason)
            && (!flags.HasFlag(FlowFlags.Covered) || (hasFlow && !flags.HasFlag(FlowFlags.LeavesPicture)))
            && (!flags.HasFlag(FlowFlags.Infinite) || !flags.HasFlag(FlowFlags.Moved));
    }

    private static bool Agrees(ReadOnlySpan<ushort> vector, FlowFlags flags) =>
        flags.HasFlag(FlowFlags.Valid) ? vector[2] == 1 : vector[0] == 0 && vector[1] == 0 && vector[2] == 0;

    /// <summary>A surface that does not move has the motion zero, and people, the unknown and the sky have none.</summary>
    private static bool Fits(ReadOnlySpan<ushort> motion, FlowFlags flags)
    {
        bool isNone = motion[0] == 0 && motion[1] == 0 && motion[2] == 0;
        return (flags & (FlowFlags.Person | FlowFlags.Unknown | FlowFlags.Infinite)) == 0 || isNone;
    }
}
