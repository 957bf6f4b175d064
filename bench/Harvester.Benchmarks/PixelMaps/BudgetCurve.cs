using System.Globalization;
using System.Text;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Tests.Scenes;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>Draws mean agreement over ray budget as an SVG.</summary>
internal static class BudgetCurve
{
    private const int Left = 60;
    private const int Top = 40;
    private const int Width = 520;
    private const int Height = 300;
    private const double LowestIou = 0.4;

    public static string Draw(ImageSize size, double[] budgets, MapScores[] scores)
    {
        var svg = new StringBuilder();
        svg.Append("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 420\" font-family=\"sans-serif\" font-size=\"12\">\n");
        svg.Append("<rect width=\"640\" height=\"420\" fill=\"#ffffff\"/>\n");
        Append(svg, $"<text x=\"{Left}\" y=\"24\" font-size=\"15\">Pixel maps of 50 street scenes, {size.Width} × {size.Height}: mean IoU over ray budget</text>\n");
        double greatest = budgets[^1];
        for (double iou = LowestIou; iou < 1.01; iou += 0.1)
        {
            Append(svg, $"<line x1=\"{Left}\" x2=\"{Left + Width}\" y1=\"{Y(iou):F1}\" y2=\"{Y(iou):F1}\" stroke=\"#dddddd\"/><text x=\"{Left - 30}\" y=\"{Y(iou) + 4:F1}\">{iou:F1}</text>\n");
        }

        for (double budget = 0; budget <= greatest + 1e-9; budget += 0.0025)
        {
            Append(svg, $"<text x=\"{X(budget, greatest) - 14:F1}\" y=\"{Top + Height + 18}\">{budget * 100:F2}</text>\n");
        }

        Append(svg, $"<text x=\"{Left + 130}\" y=\"{Top + Height + 40}\">rays allowed, % of one for every pixel</text>\n");
        Curve(svg, budgets, [.. scores.Select(s => s.Large.Average())], "#0b5fa5", "256 visible pixels and more", 0);
        Curve(svg, budgets, [.. scores.Select(s => s.Medium.Average())], "#c2570c", "64 to 256", 1);
        svg.Append("</svg>\n");
        return svg.ToString();
    }

    private static void Curve(StringBuilder svg, double[] budgets, double[] values, string colour, string name, int place)
    {
        double greatest = budgets[^1];
        svg.Append("<polyline fill=\"none\" stroke-width=\"2\" stroke=\"").Append(colour).Append("\" points=\"");
        for (int i = 0; i < budgets.Length; i++)
        {
            Append(svg, $"{X(budgets[i], greatest):F1},{Y(Math.Max(LowestIou, values[i])):F1} ");
        }

        svg.Append("\"/>\n");
        Append(svg, $"<text x=\"{Left + 330}\" y=\"{Top + Height - 40 + (place * 18)}\" fill=\"{colour}\">{name}</text>\n");
    }

    private static double X(double budget, double greatest) => Left + (Width * budget / greatest);

    private static double Y(double iou) => Top + (Height * (1 - iou) / (1 - LowestIou));

    private static void Append(StringBuilder svg, FormattableString text) => svg.Append(text.ToString(CultureInfo.InvariantCulture));
}
