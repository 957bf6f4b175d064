using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Validation;

/// <summary>All that must hold for a frame by itself.</summary>
internal sealed class FrameCheck(SessionReader session, SessionInfo? info, bool isQuick)
{
    private readonly FileCheck _files = new(session, isQuick);
    private readonly SceneCheck _scenes = new(session, info);
    private readonly LaneIdCheck _laneIds = new(session);

    /// <summary>Takes the names of a label for it, and returns those that an earlier one has. Labels come in their order.</summary>
    public IReadOnlyList<string> Claim(FrameLabel label) => _files.Claim(label);

    /// <summary>What is wrong with a line that could be read; several may be asked for at once.</summary>
    public IReadOnlyList<string> Problems(CheckedLine line)
    {
        try
        {
            return ProblemsOfAll(line);
        }
        catch (DatasetFormatException e)
        {
            // A file of the frame may not be opened: it is outside the session, or a pipe.
            return [e.Message];
        }
    }

    private string[] ProblemsOfAll(CheckedLine line)
    {
        FrameLabel label = line.Source.Label!;
        return
        [
            .. info?.Rig is { } rig ? RigCheck.Problems(rig, label) : SizeProblems(label),
            .. CameraCheck.Problems(label.Camera),
            .. line.Sequence,
            .. _files.Problems(label, line.Taken, line.Manifest),
            .. new[] { _scenes.Problem(label, line.Manifest) }.OfType<string>(),
            .. line.Source.Findings,
            .. label.Lanes is { } lanes ? LanesCheck.Problems(lanes) : [],
            .. _laneIds.Problems(label),
            .. MotionCheck.Problems(label),
            .. ImuCheck.Problems(label),
            .. GnssCheck.Problems(label),
            .. RadarCheck.Problems(label),
            .. DriveCheck.Problems(label),
            .. IgnoreRegionCheck.Problems(label),
            .. label.Objects.SelectMany(item => ObjectCheck.Problems(item, label)),
        ];
    }

    private IEnumerable<string> SizeProblems(FrameLabel label)
    {
        if (info is not null && (label.Camera.Width != info.Image.Width || label.Camera.Height != info.Image.Height))
        {
            yield return $"camera.width and camera.height are {label.Camera.Width} x {label.Camera.Height}, "
                + $"but the session's images are {info.Image.Width} x {info.Image.Height}.";
        }
    }
}
