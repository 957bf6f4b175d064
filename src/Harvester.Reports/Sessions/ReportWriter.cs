using Harvester.Datasets.Derivation;
using Harvester.Datasets.Statistics;
using Harvester.Exports.Predictions;
using Harvester.Pages;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Reports.Sessions;

/// <summary>
/// Writes a session as one HTML page: its frames with their boxes, and its statistics. The images are embedded or linked.
/// </summary>
public sealed class ReportWriter
{
    /// <summary>Default name of a session's report.</summary>
    public const string FileName = SessionFolder.Report;

    private readonly SessionReader _session;
    private readonly ReportLimits _limits;
    private readonly PredictionEvaluation? _predictions;

    /// <summary>Creates a writer for the report of a session.</summary>
    /// <param name="session">The session.</param>
    /// <param name="limits">Limits of the page; null for the defaults.</param>
    /// <param name="predictions">Predictions to show; null for none.</param>
    public ReportWriter(SessionReader session, ReportLimits? limits = null, PredictionEvaluation? predictions = null)
    {
        _session = session;
        _limits = limits ?? new ReportLimits();
        _predictions = predictions;
    }

    /// <summary>Writes the report. An existing one is replaced only when the new one is complete.</summary>
    /// <param name="path">The file to write.</param>
    /// <returns>The number of frames shown.</returns>
    /// <exception cref="DatasetFormatException">The session cannot be read.</exception>
    /// <exception cref="IOException">A file cannot be read or written.</exception>
    public int Write(string path)
    {
        int shown = 0;
        AtomicFile.Write(path, stream => shown = Write(stream, Path.GetDirectoryName(Path.GetFullPath(path))!));
        return shown;
    }

    private int Write(Stream stream, string folder)
    {
        SessionInfo info = _session.ReadInfo();
        SessionStatistics statistics = SessionStatistics.Of(_session.ReadLabels());
        IReadOnlyList<int> places = FrameChoice.Of(statistics.Frames, _limits.Frames, _predictions);
        List<FrameLabel> frames = Shown(places);
        PictureEmbedder? embedder = null;
        if (!_limits.LinksImages && frames.Count > 0)
        {
            (embedder, int count) = PictureEmbedder.Fitting(PathsOf(frames), _limits.ImageBytes);
            IReadOnlyList<int> kept = EvenSelection.Of(frames.Count, count);
            frames = [.. kept.Select(index => frames[index])];
            places = [.. kept.Select(index => places[index])];
        }

        string title = Path.GetFileName(Path.GetFullPath(_session.Folder));
        ReportPage.Write(
            stream,
            $"{title}: session report",
            ReportPage.ScriptsOfReport,
            page =>
            {
                page.Json(
                    "data",
                    json =>
                        ReportData.Write(
                            json,
                            title,
                            info,
                            statistics,
                            frames,
                            _session.ReadEvents(),
                            embedder?.Scale ?? 1,
                            _predictions is not null,
                            _limits.ShowsPosts
                        )
                );
                if (_predictions is { } predictions)
                {
                    page.Json("predictions", json => ReportPredictions.Write(json, predictions, places, frames));
                }

                if (embedder is null)
                {
                    WriteLinks(page, PathsOf(frames), folder);
                }
                else
                {
                    WritePictures(page, embedder.Embed(PathsOf(frames)));
                    WriteMasks(page, frames);
                }
            }
        );
        return frames.Count;
    }

    private List<FrameLabel> Shown(IReadOnlyList<int> chosen)
    {
        var frames = new List<FrameLabel>();
        int labels = 0;
        foreach (FrameLabel frame in LabelsAt(chosen))
        {
            labels += frame.Objects.Count;
            if (labels > _limits.Labels)
            {
                throw new DatasetFormatException(
                    $"'{_session.Folder}': the {chosen.Count} frames of the report have more than "
                        + $"{_limits.Labels} labels together, the limit. Use --frames for fewer."
                );
            }

            frames.Add(frame);
        }

        return frames;
    }

    private string[] PathsOf(IEnumerable<FrameLabel> frames) => [.. frames.Select(frame => _session.PathOf(frame.Image))];

    private IEnumerable<FrameLabel> LabelsAt(IReadOnlyList<int> indices)
    {
        int next = 0;
        int index = 0;
        foreach (FrameLabel label in _session.ReadLabels())
        {
            if (next < indices.Count && indices[next] == index++)
            {
                next++;
                yield return label;
            }
        }
    }

    private static void WriteLinks(MarkupWriter page, IEnumerable<string> paths, string folder)
    {
        foreach ((int index, string path) in paths.Index())
        {
            StartImage(page, index);
            page.With("data-href", Address(folder, path)).End().NewLine();
        }
    }

    private static void WritePictures(MarkupWriter page, IEnumerable<EmbeddedPicture> pictures)
    {
        foreach ((int index, EmbeddedPicture picture) in pictures.Index())
        {
            StartImage(page, index);
            page.With("data-type", picture.MediaType).Base64(picture.Bytes).End().NewLine();
        }
    }

    /// <summary>Embeds the instance masks, if they are small enough together.</summary>
    private void WriteMasks(MarkupWriter page, List<FrameLabel> frames)
    {
        (int Index, string Path)[] masks =
        [
            .. frames
                .Index()
                .Where(frame => frame.Item.Mask is not null)
                .Select(frame => (frame.Index, _session.PathOf(frame.Item.Mask!)))
                .Where(mask => File.Exists(mask.Item2)),
        ];
        if (masks.Sum(mask => new FileInfo(mask.Path).Length) > _limits.MaskBytes)
        {
            return;
        }

        foreach ((int index, string path) in masks)
        {
            page.Start("script")
                .With("type", "text/plain")
                .With("id", $"mask-{index}")
                .Base64(InputFile.ReadAllBytes(path, InputFile.MaxPictureBytes))
                .End()
                .NewLine();
        }
    }

    /// <summary>Starts an image in a script element, which the browser does not decode until the page's script asks for it.</summary>
    private static void StartImage(MarkupWriter page, int index) =>
        page.Start("script").With("type", "text/plain").With("id", $"image-{index}");

    /// <summary>The address of a file, relative to the folder of a page.</summary>
    private static string Address(string folder, string file)
    {
        string path = Path.GetRelativePath(folder, Path.GetFullPath(file));
        return Path.IsPathRooted(path)
            ? new Uri(path).AbsoluteUri
            : string.Join('/', path.Split(Path.DirectorySeparatorChar).Select(Uri.EscapeDataString));
    }
}
