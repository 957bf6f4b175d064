using System.Globalization;
using System.Text;
using Harvester.Datasets.Derivation;
using Harvester.Datasets.Files;
using Harvester.Datasets.Validation;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenarios;

namespace Harvester.Datasets.Repair;

/// <summary>
/// Makes a valid session of a damaged one: of every frame that is whole. The damaged session is only read. docs/repair.md.
/// </summary>
public sealed class SessionRepairer
{
    private const int ChunkLength = 64;

    private readonly SessionReader _session;
    private readonly Action<SessionProblem> _report;
    private int _frames;
    private int _lost;
    private bool _isAllKept = true;
    private ImageSize? _image;
    private string _format = "png";

    /// <summary>Opens a damaged session; <see cref="Run"/> repairs it.</summary>
    /// <param name="folder">The damaged session.</param>
    /// <param name="report">Takes everything that was lost or corrected, in the order of the files.</param>
    /// <exception cref="DirectoryNotFoundException">There is no such folder.</exception>
    /// <exception cref="FileNotFoundException">The folder has neither labels nor session.json.</exception>
    public SessionRepairer(string folder, Action<SessionProblem> report)
    {
        _session = SessionReader.OpenDamaged(folder);
        _report = report;
    }

    /// <summary>Writes the new session.</summary>
    /// <param name="folder">Where it goes: a new or empty folder.</param>
    /// <param name="transfer">Whether files are linked or copied.</param>
    /// <param name="sync">When to wait for the disk.</param>
    /// <param name="cancellation">Stops between two frames and leaves no session.</param>
    /// <exception cref="DatasetFormatException">Nothing can be recovered.</exception>
    /// <exception cref="IOException">Something cannot be read or written.</exception>
    public SessionRepair Run(string folder, ImageTransfer transfer, SyncMode sync, CancellationToken cancellation = default)
    {
        RepairedHeader header = ReadHeader();
        _image = header.Image;
        using var manifest = new ManifestCheck(_session);
        using var digests = new CarriedDigests(_session);
        NewSession.Write(
            folder,
            sync,
            made =>
            {
                WriteFrames(made, manifest, digests, header.Info, transfer, cancellation);
                WriteOthers(made, manifest, transfer);
            },
            () => header.Text(_frames, _lost, _image!.Value, _format)
        );
        return new SessionRepair(_frames, _lost, _isAllKept);
    }

    private RepairedHeader ReadHeader()
    {
        using var manifest = new ManifestCheck(_session);
        var header = RepairedHeader.Read(_session, manifest.DigestsOf(SessionInfo.FileName));
        if (header.Problem is { } problem)
        {
            Lose(SessionInfo.FileName, null, problem);
        }

        return header;
    }

    private void WriteFrames(
        NewSession made,
        ManifestCheck manifest,
        CarriedDigests digests,
        SessionInfo? info,
        ImageTransfer transfer,
        CancellationToken cancellation
    )
    {
        if (_session.HasUnfinishedLine)
        {
            Lose(SessionReader.LabelsFile, null, "the unfinished last line is left out.");
        }

        var sequence = new SequenceCheck();
        var check = new FrameCheck(_session, info, isQuick: false);
        foreach (LabelLine[] chunk in _session.ReadLines(DerivedFieldCheck.Problems).Chunk(ChunkLength))
        {
            cancellation.ThrowIfCancellationRequested();
            CheckedLine[] lines = [.. chunk.Select(line => Prepare(line, manifest, sequence, check))];
            IReadOnlyList<string>[] found = ParallelCheck.Each<CheckedLine, IReadOnlyList<string>>(
                lines,
                line => line.Sequence.Count > 0 ? line.Sequence : check.Problems(line),
                cancellation
            );
            for (int i = 0; i < lines.Length; i++)
            {
                if (found[i].Count > 0)
                {
                    Lose(SessionReader.LabelsFile, lines[i].Source.Number, found[i][0]);
                    _lost++;
                    continue;
                }

                Place(made, lines[i].Source, digests, transfer);
            }
        }

        if (info?.CapturedFrames is { } captured && _frames + _lost < captured)
        {
            Lose(SessionReader.LabelsFile, null, $"it has {_frames + _lost} of the {captured} frames that {SessionInfo.FileName} counts.");
            _lost = captured - _frames;
        }

        if (_image is null)
        {
            throw new DatasetFormatException(
                $"'{_session.Folder}' has no whole frame and no readable {SessionInfo.FileName}; nothing can be recovered."
            );
        }
    }

    /// <summary>Looks for damage within the line first, so that a damaged line does not affect the check of the order of lines.</summary>
    private static CheckedLine Prepare(LabelLine line, ManifestCheck manifest, SequenceCheck sequence, FrameCheck check)
    {
        ManifestFrame? entry = manifest.Frame(line);
        string? problem = line.Problem ?? LineProblem(line, entry, manifest) ?? (entry is null ? NumberProblem(line.Label!) : null);
        if (problem is not null)
        {
            return new CheckedLine(line) { Sequence = [problem] };
        }

        return new CheckedLine(line)
        {
            Sequence = [.. sequence.Problems(line.Label!)],
            Taken = check.Claim(line.Label!),
            Manifest = entry,
        };
    }

    /// <summary>Whether the number of a frame, without a manifest to compare it with, is that of its image.</summary>
    private static string? NumberProblem(FrameLabel label) =>
        Path.GetFileNameWithoutExtension(label.Image) == label.Frame.ToString("D8", CultureInfo.InvariantCulture)
            ? null
            : $"frame {label.Frame} has the image '{label.Image}' of another.";

    // A line whose entry in the manifest is damaged is as good as one of a session without a manifest.
    private static string? LineProblem(LabelLine line, ManifestFrame? entry, ManifestCheck manifest) =>
        entry is null && manifest.IsDamaged ? null : manifest.LineProblem(line, entry);

    private void Place(NewSession made, LabelLine line, CarriedDigests digests, ImageTransfer transfer)
    {
        FrameLabel label = line.Label!;
        var size = new ImageSize(label.Camera.Width, label.Camera.Height);
        if (label.View is null && _image is { } known && known != size)
        {
            Lose(
                SessionReader.LabelsFile,
                line.Number,
                $"the image is {size.Width} x {size.Height}, but earlier images are {known.Width} x {known.Height}."
            );
            _lost++;
            return;
        }

        if (_frames == 0)
        {
            _image = size;
            _format = Path.GetExtension(label.Image) switch
            {
                ".jpg" => "jpeg",
                ".bmp" => "bmp",
                _ => "png",
            };
        }

        string scene = FramePaths.Scene(label.Frame);
        foreach (string name in label.Files.Concat(File.Exists(_session.PathOf(scene)) ? [scene] : []))
        {
            made.Place(name, _session, transfer, () => digests.Of(label.Frame, name));
        }

        made.EndFrame(label.Frame, line.Text);
        _frames++;
    }

    private void WriteOthers(NewSession made, ManifestCheck manifest, ImageTransfer transfer)
    {
        IReadOnlyList<SessionProblem> problems =
        [
            .. KeptFilesCheck.Problems(_session),
            .. manifest.EndProblems(isClosed: false, isWhole: false),
        ];
        foreach (SessionProblem problem in problems.Where(problem => problem.File != SessionInfo.FileName))
        {
            Lose(problem.File, problem.Line, problem.Message);
        }

        WriteEvents(made, manifest, transfer);
        string[] unreadable = [.. KeptFilesCheck.Problems(_session).Select(problem => problem.File)];
        foreach (string name in (string[])[FramePaths.Roads, FramePaths.Faces, ScenarioRecord.FileName])
        {
            if (!unreadable.Contains(name) && File.Exists(_session.PathOf(name)) && IsWhole(name, manifest))
            {
                made.Place(name, _session, transfer, () => FileDigest.OfFile(_session.PathOf(name)));
            }
        }
    }

    /// <summary>Places the events if they are whole, and writes those that can be read otherwise.</summary>
    private void WriteEvents(NewSession made, ManifestCheck manifest, ImageTransfer transfer)
    {
        if (!File.Exists(_session.PathOf(FramePaths.Events)))
        {
            return;
        }

        if (manifest.DigestsOf(FramePaths.Events).Count > 0 && IsWhole(FramePaths.Events, manifest))
        {
            made.Place(FramePaths.Events, _session, transfer, () => FileDigest.OfFile(_session.PathOf(FramePaths.Events)));
            return;
        }

        var lines = new StringBuilder();
        foreach (EventLine line in _session.ReadEventLines())
        {
            if (line.Event is not null && EventCheck.FirstProblem(line.Event) is null)
            {
                lines.Append(line.Text).Append('\n');
            }
            else
            {
                Lose(FramePaths.Events, line.Number, line.Problem ?? EventCheck.FirstProblem(line.Event!)!);
            }
        }

        byte[] text = Encoding.UTF8.GetBytes(lines.ToString());
        made.WriteFile(FramePaths.Events, stream => stream.Write(text));
    }

    private bool IsWhole(string name, ManifestCheck manifest) =>
        manifest.DigestsOf(name) is { Count: > 0 } digests
            ? DigestCheck.Problem(_session.PathOf(name), digests) is null
            : !manifest.IsThere || manifest.IsDamaged;

    private void Lose(string file, int? line, string message)
    {
        _isAllKept = false;
        _report(new SessionProblem(file, line, message));
    }
}
