using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Validation;

/// <summary>
/// Checks that the manifest of a session lists every frame and every other file, and that their contents match it. Frames must be checked
/// in the order of the labels.
/// </summary>
internal sealed class ManifestCheck : IDisposable
{
    private readonly SessionReader _session;
    private readonly ManifestReader? _manifest;

    public ManifestCheck(SessionReader session)
    {
        _session = session;
        _manifest = ManifestReader.Open(session);
    }

    /// <summary>Whether there is a manifest.</summary>
    public bool IsThere => _manifest is not null;

    /// <summary>Whether lines read so far were damaged.</summary>
    public bool IsDamaged => _manifest is { Problems.Count: > 0 };

    /// <summary>The entry of a label line; null without one.</summary>
    public ManifestFrame? Frame(LabelLine line) => _manifest?.Find(FileDigest.Of(line.Text), line.Label?.Frame);

    /// <summary>What is wrong with a label line, whatever it says; null for nothing.</summary>
    public string? LineProblem(LabelLine line, ManifestFrame? frame) =>
        _manifest is null ? null
        : frame is null ? $"frame {line.Label!.Frame} has no intact line in {Manifest.FileName}."
        : frame.Label != FileDigest.Of(line.Text) ? $"the line is damaged: its SHA-256 differs from {Manifest.FileName}."
        : null;

    /// <summary>
    /// What is wrong with the manifest itself and with files that belong to no single frame, once all frames were asked for.
    /// </summary>
    /// <param name="isClosed">Whether the session was closed, so that the manifest lists the frames of the session and no others.</param>
    /// <param name="isWhole">Whether no line of the labels was found damaged.</param>
    public IEnumerable<SessionProblem> EndProblems(bool isClosed, bool isWhole)
    {
        if (_manifest is null)
        {
            yield break;
        }

        _manifest.ReadToEnd();

        // Of a session that was not closed, the last line may be cut off.
        foreach (SessionProblem problem in isClosed || !_manifest.IsUnfinished ? _manifest.Problems : _manifest.Problems.SkipLast(1))
        {
            yield return problem;
        }

        if (isClosed && isWhole && _manifest.Passed > 0)
        {
            yield return new SessionProblem(
                Manifest.FileName,
                null,
                $"it lists {Counted.Of(_manifest.Passed, "frame")} not in {SessionReader.LabelsFile}."
            );
        }

        string[] known =
        [
            SessionInfo.FileName,
            FramePaths.Roads,
            FramePaths.Faces,
            ScenarioRecord.FileName,
            .. isClosed ? [FramePaths.Events] : (string[])[],
        ];
        foreach (string name in known.Where(name => !_manifest.Files.ContainsKey(name) && File.Exists(_session.PathOf(name))))
        {
            yield return new SessionProblem(name, null, $"it has no intact line in {Manifest.FileName}.");
        }

        foreach ((string name, List<FileDigest> digests) in _manifest.Files)
        {
            // A resumed harvest appends to the events, whose line is that of the run before until it is closed.
            if (!isClosed && name == FramePaths.Events)
            {
                continue;
            }

            if (Problem(name, digests) is { } problem)
            {
                yield return new SessionProblem(name, null, problem);
            }
        }
    }

    /// <inheritdoc />
    public void Dispose() => _manifest?.Dispose();

    /// <summary>What a file that belongs to no single frame may be, once all frames were asked for; none without an entry.</summary>
    public IReadOnlyList<FileDigest> DigestsOf(string name)
    {
        _manifest?.ReadToEnd();
        return _manifest is not null && _manifest.Files.TryGetValue(name, out List<FileDigest>? digests) ? digests : [];
    }

    private string? Problem(string name, List<FileDigest> digests)
    {
        try
        {
            string path = _session.PathOf(name);
            return !File.Exists(path) ? $"it is missing, but listed in {Manifest.FileName}."
                : DigestCheck.Problem(path, digests) is { } problem ? $"it {problem}"
                : null;
        }
        catch (DatasetFormatException e)
        {
            return e.Message;
        }
    }
}
