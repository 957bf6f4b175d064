using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Harvester.Datasets.Files;
using Harvester.Datasets.Images;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Statistics;
using Harvester.Pages;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Reports;

/// <summary>
/// Writes a session as one HTML page: its frames with their boxes, and its statistics. The page holds the images unless it is to link them.
/// </summary>
public sealed class ReportWriter
{
    /// <summary>Name of a session's report when none is given.</summary>
    public const string FileName = "report.html";

    private readonly SessionReader _session;
    private readonly ReportLimits _limits;

    /// <summary>Reports on a session.</summary>
    public ReportWriter(SessionReader session, ReportLimits? limits = null)
    {
        _session = session;
        _limits = limits ?? new ReportLimits();
    }

    /// <summary>Writes the report; an older one is replaced only when the new one is complete.</summary>
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
        IReadOnlyList<int> chosen = Choose(statistics.Frames);
        List<FrameLabel> frames = [.. LabelsAt(chosen)];

        string title = Path.GetFileName(Path.GetFullPath(_session.Folder));
        HtmlPage.Write(stream, $"{title}: session report", Asset("report.css"), page =>
        {
            page.Markup(Asset("report.html"));
            page.Json("data", json => ReportData.Write(json, title, info, statistics, frames));
            foreach ((int index, FrameLabel frame) in frames.Index())
            {
                WriteImage(page, $"image-{index}", _session.PathOf(frame.Image), folder);
            }

            page.Code("script", Asset("report.js"));
        });
        return frames.Count;
    }

    private IReadOnlyList<int> Choose(int count)
    {
        IReadOnlyList<int> chosen = EvenSelection.Of(count, _limits.Frames);
        if (_limits.LinksImages)
        {
            return chosen;
        }

        long bytes = LabelsAt(chosen).Sum(label => new FileInfo(_session.PathOf(label.Image)).Length);
        return bytes <= _limits.ImageBytes
            ? chosen
            : EvenSelection.Of(count, (int)Math.Max(1, chosen.Count * _limits.ImageBytes / bytes));
    }

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

    /// <summary>An image as the page's script finds it: a script element holds it without the browser decoding it at once.</summary>
    private void WriteImage(MarkupWriter page, string id, string path, string folder)
    {
        page.Start("script").With("type", "text/plain").With("id", id);
        if (_limits.LinksImages)
        {
            page.With("data-href", Address(folder, path));
        }
        else
        {
            page.With("data-type", ImageHeader.Read(path).MediaType).Base64(InputFile.ReadAllBytes(path, InputFile.MaxPictureBytes));
        }

        page.End().NewLine();
    }

    /// <summary>A file as a page in a folder names it.</summary>
    private static string Address(string folder, string file)
    {
        string path = Path.GetRelativePath(folder, Path.GetFullPath(file));
        return Path.IsPathRooted(path)
            ? new Uri(path).AbsoluteUri
            : string.Join('/', path.Split(Path.DirectorySeparatorChar).Select(Uri.EscapeDataString));
    }

    private static string Asset(string name)
    {
        using Stream stream = typeof(ReportWriter).Assembly.GetManifestResourceStream($"Harvester.Datasets.Reports.Assets.{name}")!;
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd().ReplaceLineEndings("\n");
    }
}
