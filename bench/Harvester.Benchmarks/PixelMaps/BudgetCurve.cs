using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Pages;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>Draws mean agreement over ray budget as an SVG.</summary>
internal static class BudgetCurve
{
    private const int Left = 60;
    private const int Top = 40;
    private const int Width = 520;
    private const int Height = 300;
    private const double LowestIou = 0.4;

    public static void Write(Stream stream, ImageSize size, double[] budgets, MapScores[] scores) =>
        SvgImage.Write(
            stream,
            640,
            420,
            svg =>
            {
                svg.Start("g").With("font-family", "sans-serif").With("font-size", 12).NewLine();
                svg.Start("text").With("x", Left).With("y", 24).With("font-size", 15);
                svg.Text($"Pixel maps of 50 street scenes, {size.Width} × {size.Height}: mean IoU over ray budget").End().NewLine();
                double greatest = budgets[^1];
                for (double iou = LowestIou; iou < 1.01; iou += 0.1)
                {
                    svg.Start("line")
                        .With("x1", Left)
                        .With("x2", Left + Width)
                        .With("y1", Y(iou))
                        .With("y2", Y(iou))
                        .With("stroke", "#dddddd")
                        .End();
                    Label(svg, Left - 30, Y(iou) + 4, iou.ToString("F1", CultureInfo.InvariantCulture));
                }

                for (double budget = 0; budget <= greatest + 1e-9; budget += 0.0025)
                {
                    Label(svg, X(budget, greatest) - 14, Top + Height + 18, (budget * 100).ToString("F2", CultureInfo.InvariantCulture));
                }

                Label(svg, Left + 130, Top + Height + 40, "ray budget, % of one ray per pixel");
                Curve(svg, budgets, [.. scores.Select(s => s.Large.Average())], "#0b5fa5", "256 visible pixels and more", 0);
                Curve(svg, budgets, [.. scores.Select(s => s.Medium.Average())], "#c2570c", "64 to 256", 1);
                svg.End().NewLine();
            }
        );

    private static void Curve(MarkupWriter svg, double[] budgets, double[] values, string colour, string name, int place)
    {
        double greatest = budgets[^1];
        svg.Start("polyline").With("fill", "none").With("stroke-width", 2).With("stroke", colour);
        svg.WithPoints(budgets.Select((budget, i) => new Vector2D(X(budget, greatest), Y(Math.Max(LowestIou, values[i]))))).End().NewLine();
        svg.Start("text").With("x", Left + 330).With("y", Top + Height - 40 + (place * 18)).With("fill", colour).Text(name).End().NewLine();
    }

    private static void Label(MarkupWriter svg, double x, double y, string text) =>
        svg.Start("text").With("x", x).With("y", y).Text(text).End().NewLine();

    private static double X(double budget, double greatest) => Left + (Width * budget / greatest);

    private static double Y(double iou) => Top + (Height * (1 - iou) / (1 - LowestIou));
}
