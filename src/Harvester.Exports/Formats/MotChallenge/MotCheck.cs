using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports.Formats.MotChallenge;

/// <summary>Checks MOTChallenge datasets: seqinfo.ini, the images it counts, the rows of gt.txt, and the list of sequences.</summary>
internal sealed class MotCheck
{
    private const int Columns = 9;
    private const double RoundingPixels = 0.002;

    private readonly DatasetContent _dataset;
    private readonly string _sequence;
    private readonly int _frames;
    private readonly Dictionary<double, double> _classes = [];
    private readonly HashSet<(double Frame, double Id)> _rows = [];
    private ImageSize? _size;

    private MotCheck(DatasetContent dataset, string sequence)
    {
        _dataset = dataset;
        _sequence = sequence;
        _frames = dataset.Files($"{sequence}/img1").Count;
    }

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset) =>
        dataset.Splits.SelectMany(split => SplitProblems(dataset, split));

    private static IEnumerable<SessionProblem> SplitProblems(DatasetContent dataset, string split)
    {
        string folder = MotWriter.Benchmark + split;
        string[] sequences = [.. dataset.Folders(folder)];
        string list = $"seqmaps/{folder}.txt";
        string[] listed = [.. dataset.Lines(list).Select(line => line.Text)];
        string[] expected = ["name", .. sequences.Select(sequence => Path.GetFileName(sequence))];
        return sequences
            .SelectMany(sequence =>
            {
                var check = new MotCheck(dataset, sequence);
                dataset.Found(split, check._frames);
                return check.InfoProblems().Concat(check.RowProblems());
            })
            .Concat(
                sequences.Length == 0 || listed.SequenceEqual(expected)
                    ? []
                    : [new SessionProblem(list, null, $"it must be the line 'name' and the sequences of {folder}.")]
            );
    }

    private IEnumerable<SessionProblem> InfoProblems()
    {
        string name = $"{_sequence}/seqinfo.ini";
        Dictionary<string, string> info = new(StringComparer.Ordinal);
        foreach ((_, string text) in _dataset.Lines(name))
        {
            int equals = text.IndexOf('=', StringComparison.Ordinal);
            info[equals < 0 ? text : text[..equals]] = text[(equals + 1)..];
        }

        ImageHeader? header = null;
        string? problem =
            !info.ContainsKey("[Sequence]") ? "it is missing, or has no section [Sequence]."
            : info.GetValueOrDefault("name") != Path.GetFileName(_sequence) ? "name is not that of its folder."
            : info.GetValueOrDefault("imDir") != "img1" ? "imDir is not img1."
            : !(Number(info, "frameRate") > 0) ? "frameRate is not a number above 0."
            : Number(info, "seqLength") != _frames ? $"seqLength is not {_frames}, the number of images in img1."
            : Enumerable.Range(1, _frames).FirstOrDefault(frame => !_dataset.Has(Image(frame, info.GetValueOrDefault("imExt"))))
                is var lost
                    and > 0
                ? $"img1 has no image {lost:D6}{info.GetValueOrDefault("imExt")}."
            : (header = _dataset.Header(Image(1, info["imExt"]))) is not null
            && (Number(info, "imWidth") != header.Size.Width || Number(info, "imHeight") != header.Size.Height)
                ? $"imWidth and imHeight are not those of its images, {header.Size.Width} x {header.Size.Height}."
            : null;
        _size = header?.Size;
        return problem is null ? [] : [new SessionProblem(name, null, problem)];
    }

    private IEnumerable<SessionProblem> RowProblems()
    {
        string name = $"{_sequence}/gt/gt.txt";
        return !_dataset.Has(name)
            ? [new SessionProblem(name, null, "it is missing.")]
            : _dataset
                .Lines(name)
                .Select(line => (line.Number, Problem: RowProblem(line.Text.Split(','))))
                .Where(row => row.Problem is not null)
                .Select(row => new SessionProblem(name, row.Number, row.Problem!));
    }

    private string? RowProblem(string[] words)
    {
        if (
            words.Length != Columns
            || Numbers.Parse(words) is not [var frame, var id, var left, var top, var width, var height, var flag, var kind, var visible]
        )
        {
            return $"it must have {Columns} numbers, separated by commas.";
        }

        // The first pixel is 1.
        var box = new Box2D(left - 1, top - 1, left - 1 + width, top - 1 + height);
        return !(frame >= 1 && frame <= _frames) || frame != Math.Floor(frame) ? $"frame {words[0]} has no image."
            : !(id >= 1) || id != Math.Floor(id) ? "its id is not a whole number from 1."
            : !_rows.Add((frame, id)) ? $"id {words[1]} occurs twice in frame {words[0]}."
            : kind is < MotClasses.Pedestrian or > MotClasses.Last || kind != Math.Floor(kind) ? $"its class is not 1 to {MotClasses.Last}."
            : flag != (kind == MotClasses.Pedestrian ? 1 : 0) ? "its flag is not 1 for class 1 and 0 for others."
            : visible is < 0 or > 1 ? "its visibility is not 0 to 1."
            : kind != MotClasses.Distractor && !_classes.TryAdd(id, kind) && _classes[id] != kind
                ? $"id {words[1]} has class {words[7]}, but had {Numbers.Text((int)_classes[id])} in an earlier frame."
            : !(width > 0 && height > 0)
            || (_size is { } size && _dataset.Options.Boxes != BoxKind.Amodal && !size.Bounds.Contains(box, RoundingPixels))
                ? $"its box does not lie in the image{(_size is { } known ? $" of {known.Width} x {known.Height}" : "")}, or has no area."
            : null;
    }

    private string Image(int frame, string? extension) => $"{_sequence}/img1/{frame:D6}{extension}";

    private static double? Number(Dictionary<string, string> info, string key) =>
        info.TryGetValue(key, out string? text) ? Numbers.Parse([text])?[0] : null;
}
