using Harvester.Sessions.Labels;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Datasets.Validation;

/// <summary>
/// Checks the files that labels refer to: they lie in the session, belong to one frame only, are complete, have the size in the label and
/// agree with the manifest; masks and class maps agree with the labels.
/// </summary>
/// <param name="session">The session.</param>
/// <param name="isQuick">Whether pictures are not decoded.</param>
internal sealed class FileCheck(SessionReader session, bool isQuick)
{
    private const int MaskBitsPerPixel = 16;

    private readonly HashSet<string> _named = new(StringComparer.Ordinal);

    /// <summary>Takes the names of a label for it, and returns those that an earlier one has. Labels come in their order.</summary>
    public IReadOnlyList<string> Claim(FrameLabel label) => [.. label.Files.Where(name => session.IsWithin(name) && !_named.Add(name))];

    /// <summary>What is wrong with the files of a label; several labels may be asked for at once.</summary>
    /// <param name="label">The label.</param>
    /// <param name="taken">Names in it that an earlier label has.</param>
    /// <param name="manifest">What the manifest says of the frame; null for nothing.</param>
    public IEnumerable<string> Problems(FrameLabel label, IReadOnlyList<string> taken, ManifestFrame? manifest)
    {
        IEnumerable<string> mask = label.Mask is { } name
            ? MaskProblems(label, name, taken, manifest)
            : MaskCheck.ProblemsWithoutMask(label);
        IEnumerable<string> channels = FrameChannels.All.SelectMany(channel =>
            channel.LabelIn(label.Channels) is { } found ? ChannelProblems(channel, found, label, taken, manifest) : []
        );
        mask = mask.Concat(channels);
        return Problem("image", label.Image, SizeOf(label.Camera), null, taken, manifest) is { } image ? mask.Prepend(image) : mask;
    }

    private IEnumerable<string> MaskProblems(FrameLabel label, string name, IReadOnlyList<string> taken, ManifestFrame? manifest)
    {
        if (Problem("mask", name, SizeOf(label.Camera), MaskBitsPerPixel, taken, manifest) is { } problem)
        {
            return [problem];
        }

        try
        {
            return isQuick ? [] : MaskCheck.Problems(label, PngDecoder.ReadInstanceMap(session.PathOf(name)));
        }
        catch (DatasetFormatException e)
        {
            return [$"mask '{name}' cannot be used: {e.Message}"];
        }
    }

    private IEnumerable<string> ChannelProblems(
        FrameChannel channel,
        IChannelLabel found,
        FrameLabel label,
        IReadOnlyList<string> taken,
        ManifestFrame? manifest
    )
    {
        if (found is SweepsLabel { Sweeps: { } sweeps })
        {
            return sweeps.Select(sweep => SweepProblem(sweep, taken, manifest)).OfType<string>();
        }

        if (found is FlowLabel link && FlowCheck.ProblemOf(link, label) is { } misled)
        {
            return [misled];
        }

        string[] problems =
        [
            .. found
                .Files.Select(name =>
                    Problem(channel.FileKind, name, channel.SizeOf(found, label.Camera), channel.BitsOf(found, name), taken, manifest)
                )
                .OfType<string>(),
        ];
        if (problems.Length > 0 || isQuick)
        {
            return problems;
        }

        try
        {
            return found switch
            {
                ClassMapLabel map => [.. ClassMapCheck.Problems(map.File, PngDecoder.ReadLabelMap(session.PathOf(map.File)))],
                BirdsEyeLabel map => [.. BirdsEyeCheck.Problems(map, name => PngDecoder.ReadLabelMap(session.PathOf(name)))],
                OccupancyLabel map =>
                [
                    .. OccupancyCheck.Problems(
                        map,
                        name => PngDecoder.ReadLabelMap(session.PathOf(name)),
                        name => PngDecoder.ReadInstanceMap(session.PathOf(name))
                    ),
                ],
                FlowLabel flow => [.. FlowCheck.Problems(flow.Maps, session.PathOf)],
                DepthLabel depth => [.. DepthCheck.Problems(depth, name => PngDecoder.ReadInstanceMap(session.PathOf(name)))],
                _ => Array.Empty<string>(),
            };
        }
        catch (DatasetFormatException e)
        {
            return [$"{channel.FileKind} '{found.Files.First()}' cannot be used: {e.Message}"];
        }
    }

    private string? SweepProblem(SweepLabel sweep, IReadOnlyList<string> taken, ManifestFrame? manifest)
    {
        string what = $"lidar '{sweep.File}'";
        if (PlaceProblem("lidar", sweep.File, taken) is { } problem)
        {
            return problem;
        }

        try
        {
            byte[] content = InputFile.ReadAllBytes(session.PathOf(sweep.File), LidarFile.MaxPoints * LidarFile.BytesPerPoint);
            int points = LidarFile.Read(content).Length;
            return points != sweep.Points ? $"{what} has {points} points, but its label says {sweep.Points}."
                : DigestCheck.Problem(session.PathOf(sweep.File), sweep.File, manifest) is { } damage ? $"{what} {damage}"
                : null;
        }
        catch (Exception e) when (e is FormatException or DatasetFormatException)
        {
            return $"{what} cannot be used: {e.Message}";
        }
    }

    private string? PlaceProblem(string field, string name, IReadOnlyList<string> taken) =>
        !session.IsWithin(name) ? $"{field} '{name}' points outside the session."
        : taken.Contains(name) ? $"{field} '{name}' is already used by an earlier line."
        : !File.Exists(session.PathOf(name)) ? $"{field} '{name}' is missing."
        : null;

    private string? Problem(
        string field,
        string name,
        (int Width, int Height) size,
        int? bitsPerPixel,
        IReadOnlyList<string> taken,
        ManifestFrame? manifest
    )
    {
        if (PlaceProblem(field, name, taken) is { } missing)
        {
            return missing;
        }

        string path = session.PathOf(name);
        try
        {
            if (Problem($"{field} '{name}'", ImageHeader.Read(path), size, bitsPerPixel) is { } problem)
            {
                return problem;
            }

            if (!isQuick)
            {
                PictureIntegrity.Check(path);
            }

            return DigestCheck.Problem(path, name, manifest) is { } damage ? $"{field} '{name}' {damage}" : null;
        }
        catch (DatasetFormatException e)
        {
            return $"{field} '{name}' cannot be used: {e.Message}";
        }
    }

    private static (int Width, int Height) SizeOf(CameraLabel camera) => (camera.Width, camera.Height);

    private static string? Problem(string what, ImageHeader header, (int Width, int Height) size, int? bitsPerPixel)
    {
        if (header.Size.Width != size.Width || header.Size.Height != size.Height)
        {
            return $"{what} is {header.Size.Width} x {header.Size.Height}, but its label says {size.Width} x {size.Height}.";
        }

        return bitsPerPixel is { } bits && header.BitsPerPixel != bits
            ? $"{what} has {header.BitsPerPixel} bits per pixel instead of {bits}."
            : null;
    }
}
