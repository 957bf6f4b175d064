using System.Globalization;
using System.Text.Json;
using Harvester.Capture.Harvesting;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Simulation.Game;

namespace Harvester.Simulation.Tests.Lanes;

/// <summary>Reads each label line that a harvest writes, and compares every point of its markings with the picture.</summary>
internal sealed class MarkingJudge(SimulatedGame game) : IFrameSink
{
    private const double Nearest = 5;
    private const double Furthest = 50;
    private const int Fineness = 4;

    /// <summary>A point this near to the middle of a stripe is on it, pixels of the labels' image.</summary>
    private const double OnPaint = 0.3;

    private readonly List<double> _errors = [];
    private int _frames;

    public static ImageSize Image { get; } = new(800, 600);

    public string? Fault => null;

    public int FirstFrame => 0;

    public int FirstObjectId => 1;

    public int FirstEventId => 1;

    /// <summary>Points of markings from 5 to 50 m that are labelled as painted and not hidden.</summary>
    public int Points { get; private set; }

    public int Judged => _errors.Count;

    /// <summary>
    /// Points that lie on no paint though nothing stands before them, and points labelled as in a gap, far from its ends, that lie on
    /// paint.
    /// </summary>
    public List<string> Faults { get; } = [];

    /// <summary>Pixels of the labels' image.</summary>
    public double MaxError => _errors.Max();

    public void Open(SessionStart start) { }

    public bool TryEnqueue(CapturedFrame frame)
    {
        using JsonDocument label = JsonDocument.Parse(JsonLabelWriter.Line(frame.Label));
        frame.Dispose();
        _frames++;
        if (
            label.RootElement.GetProperty("lanes").GetProperty("markings") is { ValueKind: JsonValueKind.Array } markings
            && markings.GetArrayLength() > 0
        )
        {
            var picture = new PaintInPicture(
                game.Render(new ImageSize(Image.Width * Fineness, Image.Height * Fineness)),
                game.Shown.Camera
            );
            foreach (JsonElement marking in markings.EnumerateArray())
            {
                Judge(marking, picture);
            }
        }

        return true;
    }

    public void Close(SessionEnd end) { }

    public void Dispose() { }

    public override string ToString() =>
        string.Create(
            CultureInfo.InvariantCulture,
            $"{Points} points, {Judged} judged; error {_errors.DefaultIfEmpty().Max():0.00} px at most, "
                + $"{_errors.Order().ElementAtOrDefault(Judged * 95 / 100):0.00} px at the 95th percentile"
        );

    private void Judge(JsonElement marking, PaintInPicture picture)
    {
        var line = new WrittenMarking(marking);

        // At its ends a marking's paint begins and ends: on one side of a cut there is none.
        for (int i = 1; i + 1 < line.Count; i++)
        {
            if (line.Depth(i) is < Nearest or > Furthest || line.IsHidden(i))
            {
                continue;
            }

            PaintFinding found = picture.Find(line, i, Fineness);
            double error = Math.Abs(found.OffsetPixels) / Fineness;
            Points += line.IsPainted(i) ? 1 : 0;
            if (line.IsPainted(i) && found.Kind == PaintFindingKind.Paint)
            {
                _errors.Add(error);
            }

            if (
                line.IsPainted(i)
                    ? found.Kind == PaintFindingKind.NoPaint
                    : line.IsWithinGap(i) && found.Kind == PaintFindingKind.Paint && error < OnPaint
            )
            {
                Faults.Add($"frame {_frames}, {line.Point(i)} at {line.Pixel(i)}: {(line.IsPainted(i) ? "no paint" : "paint in a gap")}");
            }
        }
    }
}
