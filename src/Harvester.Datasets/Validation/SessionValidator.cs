using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>Looks whether a session is what docs/dataset-format.md promises, and collects all that is not.</summary>
public static class SessionValidator
{
    /// <summary>Validates a session.</summary>
    /// <param name="session">The session.</param>
    /// <param name="cancellation">Stops between two lines.</param>
    public static SessionValidation Validate(SessionReader session, CancellationToken cancellation = default)
    {
        var problems = new List<SessionProblem>();
        SessionInfo? info = ReadInfo(session, problems);
        var sequence = new SequenceCheck();
        var files = new FileCheck(session);
        var scenes = new SceneCheck(session, info);
        int frames = 0;
        int objects = 0;
        int undetermined = 0;
        int undeterminedRegions = 0;
        foreach (LabelLine line in session.ReadLines())
        {
            cancellation.ThrowIfCancellationRequested();
            IEnumerable<string> found = [line.Problem!];
            if (line.Label is { } label)
            {
                frames++;
                objects += label.Objects.Count;
                undetermined += label.Objects.Count(item => item.IsUndetermined);
                undeterminedRegions += label.IgnoreRegions.Count(region => region.Reason == IgnoreReason.Undetermined);
                found =
                [
                    .. SizeProblems(label, info),
                    .. CameraCheck.Problems(label.Camera),
                    .. sequence.Problems(label),
                    .. files.Problems(label),
                    .. new[] { scenes.Problem(label) }.OfType<string>(),
                    .. DerivedFieldCheck.Problems(label, line.Text),
                    .. label.Lanes is { } lanes ? LanesCheck.Problems(lanes) : [],
                    .. IgnoreRegionCheck.Problems(label),
                    .. label.Objects.SelectMany(item => ObjectCheck.Problems(item, label)),
                ];
            }

            problems.AddRange(found.Select(message => new SessionProblem(SessionReader.LabelsFile, line.Number, message)));
        }

        problems.AddRange(KeptFilesCheck.Problems(session));
        if (info?.CapturedFrames is { } captured && captured != frames)
        {
            problems.Add(new SessionProblem(
                SessionInfo.FileName,
                    null, $"it counts {captured} captured frames, but {SessionReader.LabelsFile} has {frames} good lines."));
        }

        return new SessionValidation(
            info, frames, objects, problems)
        { Undetermined = undetermined, UndeterminedRegions = undeterminedRegions };
    }

    private static SessionInfo? ReadInfo(SessionReader session, List<SessionProblem> problems)
    {
        try
        {
            return SessionInfo.Read(session.PathOf(SessionInfo.FileName));
        }
        catch (DatasetFormatException e)
        {
            problems.Add(new SessionProblem(SessionInfo.FileName, null, e.Message));
            return null;
        }
    }

    private static IEnumerable<string> SizeProblems(FrameLabel label, SessionInfo? info)
    {
        if (info is not null && (label.Camera.Width != info.Image.Width || label.Camera.Height != info.Image.Height))
        {
            yield return $"camera.width and camera.height are {label.Camera.Width} x {label.Camera.Height}, "
                + $"but the session's images are {info.Image.Width} x {info.Image.Height}.";
        }
    }
}
