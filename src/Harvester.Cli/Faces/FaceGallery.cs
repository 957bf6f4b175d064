using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Net;
using Harvester.Geometry;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Faces;

/// <summary>A page that needs nothing beside it: each model of a table with its faces drawn to scale and on its photographs, and the models that were photographed without a face.</summary>
internal sealed class FaceGallery(FaceTable table, string folder)
{
    private const double PixelsPerMetre = 70;
    private const double MarginMetres = 0.3;
    private readonly PhotoFigures _photos = new(folder);

    /// <summary>Writes the page and says how many models it shows.</summary>
    public int Write(TextWriter page)
    {
        page.Write(
            "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Spaces of interest</title>\n"
            + "<style>body{font:14px sans-serif;margin:1.5em}main{display:flex;flex-wrap:wrap;gap:1em}article{border:1px solid #bbb;padding:.7em}"
            + "h2{font-size:1em;margin:0 0 .4em}img{max-width:24em;display:block}.photo{margin:.3em}article>svg{display:inline-block}.estimated{stroke-dasharray:4}.away{fill-opacity:.25;stroke-opacity:.4}.hidden{stroke-dasharray:2 3;stroke-opacity:.7}td{padding-right:.8em}</style></head>\n"
            + "<body><h1>Spaces of interest</h1><p>Seen from the side towards which the first face looks. Ground and origin are the lines; dashed faces are estimated, pale ones look elsewhere. On photographs the edges that a face's own body hides are dotted. "
            + "To mend a name or a corner, edit the table, then <code>harvester spaces check</code> it and make this page anew.</p><main>\n");
        IGrouping<int, ModelFace>[] models = [.. table.Faces.GroupBy(face => face.Hash)];
        foreach (IGrouping<int, ModelFace> model in models)
        {
            WriteModel(page, [.. model]);
        }

        string[] faceless = [.. _photos.Photos.Select(photo => photo.Model).Distinct().Where(model => table.Of(model).Count == 0)];
        foreach (string model in faceless)
        {
            page.Write($"<article id=\"{Text(model)}\"><h2>{Text(model)}</h2>{_photos.Of(model, [])}<p>No face was found.</p></article>\n");
        }

        page.Write("</main></body></html>\n");
        return models.Length + faceless.Length;
    }

    private void WriteModel(TextWriter page, IReadOnlyList<ModelFace> faces)
    {
        string name = faces[0].Model.Length > 0 ? faces[0].Model : faces[0].Hash.ToString(CultureInfo.InvariantCulture);
        page.Write($"<article id=\"{Text(name)}\"><h2>{Text(name)}</h2>{Drawing(faces)}{_photos.Of(name, faces)}");
        string picture = Path.Combine(folder, name + ".png");
        if (File.Exists(picture))
        {
            page.Write($"<img alt=\"{Text(name)}\" src=\"data:image/png;base64,{Convert.ToBase64String(File.ReadAllBytes(picture))}\">");
        }

        page.Write("<table>");
        foreach (ModelFace face in faces)
        {
            page.Write(
                $"<tr><td>{face.Number}</td><td>{Text(face.Name)}</td><td>{Text(face.MutcdCode)}</td>"
                + string.Create(CultureInfo.InvariantCulture, $"<td>{Width(face):0.00} x {face.FrontUpperLeft.Z - face.BackLowerRight.Z:0.00} m</td>")
                + $"<td>{JsonName.Of(face.Provenance)}</td></tr>");
        }

        page.Write("</table></article>\n");
    }

    private static string Drawing(IReadOnlyList<ModelFace> faces)
    {
        (double Right, double Up)[][] outlines = [.. faces.Select(face => Outline(face, faces[0].Facing))];
        double left = Math.Min(0, outlines.Min(outline => outline.Min(corner => corner.Right))) - MarginMetres;
        double right = Math.Max(0, outlines.Max(outline => outline.Max(corner => corner.Right))) + MarginMetres;
        double top = Math.Max(0, outlines.Max(outline => outline.Max(corner => corner.Up))) + MarginMetres;
        string Point(double x, double z) =>
            string.Create(CultureInfo.InvariantCulture, $"{(x - left) * PixelsPerMetre:0.#},{(top - z) * PixelsPerMetre:0.#}");
        IEnumerable<string> shapes = faces.Index().OrderBy(each => Nearness(each.Item, faces[0].Facing)).Select(each =>
            $"<polygon class=\"{JsonName.Of(each.Item.Provenance)}{(each.Item.Facing == faces[0].Facing ? "" : " away")}\" fill=\"#{(each.Item.Class == ObjectClass.Sign ? "fd8" : "8cf")}\" stroke=\"#222\" "
            + $"points=\"{string.Join(" ", outlines[each.Index].Select(corner => Point(corner.Right, corner.Up)))}\"/>");
        return string.Create(
            CultureInfo.InvariantCulture,
            $"<svg width=\"{(right - left) * PixelsPerMetre:0}\" height=\"{(top + MarginMetres) * PixelsPerMetre:0}\">")
            + $"<polyline fill=\"none\" stroke=\"#999\" points=\"{Point(left, 0)} {Point(right, 0)}\"/>"
            + $"<polyline fill=\"none\" stroke=\"#999\" points=\"{Point(0, 0)} {Point(0, top)}\"/>{string.Concat(shapes)}</svg>";
    }

    /// <summary>The front outline of a face as somebody sees it who stands before a facing.</summary>
    private static (double Right, double Up)[] Outline(ModelFace face, Facing seenFrom)
    {
        var atOrigin = new Pose(Vector3D.Zero, Axes.Identity);
        return [.. FaceOutline.EdgesOf(face, atOrigin).Where((_, i) => i % 3 == 0).Select(edge => (
            seenFrom switch { Facing.Front => -edge.Start.X, Facing.Left => -edge.Start.Y, Facing.Right => edge.Start.Y, _ => edge.Start.X },
            edge.Start.Z))];
    }

    /// <summary>How far a face's front stands towards somebody who sees it from a side, metres from the model's origin.</summary>
    private static double Nearness(ModelFace face, Facing seenFrom) => seenFrom switch
    {
        Facing.Front => Math.Max(face.FrontUpperLeft.Y, face.BackLowerRight.Y),
        Facing.Left => -Math.Min(face.FrontUpperLeft.X, face.BackLowerRight.X),
        Facing.Right => Math.Max(face.FrontUpperLeft.X, face.BackLowerRight.X),
        _ => -Math.Min(face.FrontUpperLeft.Y, face.BackLowerRight.Y),
    };

    private static double Width(ModelFace face) => face.Facing is Facing.Back or Facing.Front
        ? face.BackLowerRight.X - face.FrontUpperLeft.X
        : face.FrontUpperLeft.Y - face.BackLowerRight.Y;

    private static string Text(string text) => WebUtility.HtmlEncode(text);
}
