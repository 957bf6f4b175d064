using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Validation;

/// <summary>Checks that a session follows docs/dataset-format.md, and collects all problems.</summary>
public static class SessionValidator
{
    // Frames in memory at once: enough to keep the processors busy. A parsed line takes about five times its text.
    private const int ChunkLength = 64;
    private const int ChunkCharacters = 8 << 20;

    /// <summary>Validates a session, on all processors.</summary>
    /// <param name="session">The session.</param>
    /// <param name="isQuick">Whether pictures are compared with the manifest only, and not decoded.</param>
    /// <param name="cancellation">Stops between two lines.</param>
    public static SessionValidation Validate(SessionReader session, bool isQuick = false, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(session);
        var problems = new ProblemList();
        SessionInfo? info = ReadInfo(session, problems);
        var sequence = new SequenceCheck();
        var check = new FrameCheck(session, info, isQuick);
        var events = new EventCheck(session, info);
        using var manifest = new ManifestCheck(session);
        int frames = 0;
        int objects = 0;
        int undetermined = 0;
        int undeterminedRegions = 0;
        foreach (LabelLine[] chunk in Chunks(session.ReadLines(DerivedFieldCheck.Problems)))
        {
            cancellation.ThrowIfCancellationRequested();
            var lines = new CheckedLine[chunk.Length];
            for (int i = 0; i < chunk.Length; i++)
            {
                lines[i] = new CheckedLine(chunk[i]);
                if (chunk[i].Label is { } label)
                {
                    frames++;
                    objects += label.Objects.Count;
                    undetermined += label.Objects.Count(item => item.IsUndetermined);
                    undeterminedRegions += label.IgnoreRegions.Count(region => region.Reason == IgnoreReason.Undetermined);
                    lines[i] = new CheckedLine(chunk[i])
                    {
                        Sequence = [.. sequence.Problems(label), .. events.Problems(label)],
                        Taken = check.Claim(label),
                        Manifest = manifest.Frame(chunk[i]),
                    };
                }
            }

            IReadOnlyList<string>[] found = ParallelCheck.Each<CheckedLine, IReadOnlyList<string>>(
                lines,
                line =>
                    line.Source.Problem is { } problem ? [problem]
                    : check.Problems(line) is { Count: > 0 } wrong ? wrong
                    : manifest.LineProblem(line.Source, line.Manifest) is { } damage ? [damage]
                    : [],
                cancellation
            );
            for (int i = 0; i < lines.Length; i++)
            {
                int number = lines[i].Source.Number;
                problems.AddRange(found[i].Select(message => new SessionProblem(SessionReader.LabelsFile, number, message)));
            }

            if (problems.IsFull)
            {
                break;
            }
        }

        problems.AddRange(KeptFilesCheck.Problems(session));
        problems.AddRange(events.EndProblems());
        bool isWhole = problems.Count == 0;
        SessionProblem[] ends =
        [
            .. manifest.EndProblems(info?.CapturedFrames is not null, isWhole).Where(end => problems.All(known => known.File != end.File)),
        ];
        problems.AddRange(ends);
        if (info is { HasManifest: true } && !manifest.IsThere)
        {
            problems.Add(
                new SessionProblem(
                    Manifest.FileName,
                    null,
                    $"it is missing, but {SessionInfo.FileName} says that the session was closed with it."
                )
            );
        }

        if (info?.CapturedFrames is { } captured && captured != frames)
        {
            problems.Add(
                new SessionProblem(
                    SessionInfo.FileName,
                    null,
                    $"it counts {captured} captured frames, but {SessionReader.LabelsFile} has {frames} valid lines."
                )
            );
        }

        return new SessionValidation(info, frames, objects, problems)
        {
            Undetermined = undetermined,
            UndeterminedRegions = undeterminedRegions,
            HasManifest = manifest.IsThere,
        };
    }

    private static IEnumerable<LabelLine[]> Chunks(IEnumerable<LabelLine> lines)
    {
        var chunk = new List<LabelLine>(ChunkLength);
        int characters = 0;
        foreach (LabelLine line in lines)
        {
            chunk.Add(line);
            characters += line.Text.Length;
            if (chunk.Count == ChunkLength || characters >= ChunkCharacters)
            {
                yield return [.. chunk];
                chunk.Clear();
                characters = 0;
            }
        }

        if (chunk.Count > 0)
        {
            yield return [.. chunk];
        }
    }

    private static SessionInfo? ReadInfo(SessionReader session, ProblemList problems)
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
}
