using System.Globalization;
using Harvester.Geometry;
using Harvester.Pages;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Faces;

/// <summary>
/// An HTML page that shows the faces of a table: each model with its faces, drawn to scale and on its photographs, and the photographed
/// models without faces.
/// </summary>
internal sealed class FaceGallery
{
    private const double PixelsPerMetre = 70;
    private const double MarginMetres = 0.3;
    private const string Title = "Faces of signs and traffic lights";

    private const string Style = """
        main { display: grid; grid-template-columns: repeat(auto-fill, minmax(370px, 1fr)); gap: 16px; align-items: start; }
        article { padding: 12px 14px; } article h2 { font-size: 14px; text-transform: none; letter-spacing: 0; color: var(--ink); }
        header { display: block; } header .hint { max-width: 75em; margin-top: 6px; }
        img { max-width: 100%; display: block; } svg { overflow: visible; } .photo { margin: 4px; }
        table { width: auto; margin-top: 8px; } td { text-align: left; padding: 3px 14px 3px 0; } td:nth-child(2) { white-space: normal; }
        polygon { stroke: var(--ink); } polyline { fill: none; stroke: var(--quiet); }
        .estimated { stroke-dasharray: 4; } .away { fill-opacity: .25; stroke-opacity: .4; }
        .hidden { stroke-dasharray: 2 3; stroke-opacity: .7; }

        """;

    private readonly EmbeddedPictures _pictures = new();
    private readonly FaceTable _table;
    private readonly string _folder;
    private readonly PhotoFigures _photos;
    private readonly IGrouping<int, ModelFace>[] _withFaces;
    private readonly string[] _withoutFaces;

    /// <summary>Prepares the page.</summary>
    /// <param name="table">The faces.</param>
    /// <param name="folder">The folder of the table, which may have images and photographs of its models.</param>
    public FaceGallery(FaceTable table, string folder)
    {
        _table = table;
        _folder = folder;
        _photos = new PhotoFigures(folder, _pictures);
        _withFaces = [.. table.Faces.GroupBy(face => face.Hash)];
        _withoutFaces = [.. _photos.Photos.Select(photo => photo.Model).Distinct().Where(model => _table.Of(model).Count == 0)];
    }

    /// <summary>The number of models that the page shows.</summary>
    public int Models => _withFaces.Length + _withoutFaces.Length;

    /// <summary>Writes the page.</summary>
    public void Write(Stream stream) =>
        HtmlPage.Write(
            stream,
            Title,
            Style,
            page =>
            {
                page.Start("header").Element("h1", Title).NewLine().Start("p").With("class", "hint");
                page.Text(
                    "Each model is drawn to scale, seen from the side that its first face is on. Grey lines show the ground "
                        + "and the vertical "
                        + "through the model's origin. Dashed faces are estimated; pale faces are on another side. On "
                        + "photographs, edges hidden by "
                        + "the face's own cuboid are dotted. Each row gives the number of a face, its text, its MUTCD code, "
                        + "its width and height, "
                        + "and how its corners were obtained. To correct a name or a corner, edit the table, check it with "
                );
                page.Element("code", "harvester spaces check").Text(" and create this page again.").End().NewLine().End().NewLine();
                page.Start("main").NewLine();
                foreach (IGrouping<int, ModelFace> model in _withFaces)
                {
                    WriteModel(page, [.. model]);
                }

                foreach (string model in _withoutFaces)
                {
                    StartModel(page, model);
                    _photos.Write(page, model, []);
                    page.Element("p", "No face found.").End().NewLine();
                }

                page.End().NewLine();
            }
        );

    private static void StartModel(MarkupWriter page, string name) =>
        page.Start("article").With("class", "panel").With("id", name).Element("h2", name);

    private void WriteModel(MarkupWriter page, IReadOnlyList<ModelFace> faces)
    {
        string name = faces[0].Model.Length > 0 ? faces[0].Model : faces[0].Hash.ToString(CultureInfo.InvariantCulture);
        StartModel(page, name);
        WriteDrawing(page, faces);
        _photos.Write(page, name, faces);
        string picture = name + ".png";
        if (InnerPath.IsWithin(_folder, picture) && File.Exists(InnerPath.Of(_folder, picture)))
        {
            page.Start("img").With("alt", name).WithData("src", "image/png", _pictures.Read(_folder, picture)).End();
        }

        page.Start("table");
        foreach (ModelFace face in faces)
        {
            page.Start("tr")
                .Element("td", face.Number.ToString(CultureInfo.InvariantCulture))
                .Element("td", face.Name)
                .Element("td", face.MutcdCode);
            page.Element(
                "td",
                string.Create(CultureInfo.InvariantCulture, $"{Width(face):0.00} × {face.FrontUpperLeft.Z - face.BackLowerRight.Z:0.00} m")
            );
            page.Element("td", JsonName.Of(face.Provenance)).End();
        }

        page.End().End().NewLine();
    }

    private static void WriteDrawing(MarkupWriter page, IReadOnlyList<ModelFace> faces)
    {
        (double Right, double Up)[][] outlines = [.. faces.Select(face => Outline(face, faces[0].Facing))];
        double left = Math.Min(0, outlines.Min(outline => outline.Min(corner => corner.Right))) - MarginMetres;
        double right = Math.Max(0, outlines.Max(outline => outline.Max(corner => corner.Right))) + MarginMetres;
        double top = Math.Max(0, outlines.Max(outline => outline.Max(corner => corner.Up))) + MarginMetres;
        Vector2D Pixel(double x, double z) => new((x - left) * PixelsPerMetre, (top - z) * PixelsPerMetre);
        page.Start("svg").With("width", (right - left) * PixelsPerMetre, 0).With("height", (top + MarginMetres) * PixelsPerMetre, 0);
        page.Start("polyline").WithPoints([Pixel(left, 0), Pixel(right, 0)]).End();
        page.Start("polyline").WithPoints([Pixel(0, 0), Pixel(0, top)]).End();
        foreach ((int index, ModelFace face) in faces.Index().OrderBy(each => Nearness(each.Item, faces[0].Facing)))
        {
            string away = face.Facing == faces[0].Facing ? "" : " away";
            page.Start("polygon")
                .With("class", JsonName.Of(face.Provenance) + away)
                .With("fill", face.Class == ObjectClass.Sign ? "#fd8" : "#8cf");
            page.WithPoints(outlines[index].Select(corner => Pixel(corner.Right, corner.Up))).End();
        }

        page.End();
    }

    /// <summary>The front outline of a face, seen from a side of the model.</summary>
    private static (double Right, double Up)[] Outline(ModelFace face, Facing seenFrom)
    {
        var atOrigin = new Pose(Vector3D.Zero, Axes.Identity);
        return
        [
            .. FaceOutline
                .EdgesOf(face, atOrigin)
                .Where((_, i) => i % 3 == 0)
                .Select(edge =>
                    (
                        seenFrom switch
                        {
                            Facing.Front => -edge.Start.X,
                            Facing.Left => -edge.Start.Y,
                            Facing.Right => edge.Start.Y,
                            _ => edge.Start.X,
                        },
                        edge.Start.Z
                    )
                ),
        ];
    }

    /// <summary>Distance of a face's front from the model's origin towards a viewer on a side, metres.</summary>
    private static double Nearness(ModelFace face, Facing seenFrom) =>
        seenFrom switch
        {
            Facing.Front => Math.Max(face.FrontUpperLeft.Y, face.BackLowerRight.Y),
            Facing.Left => -Math.Min(face.FrontUpperLeft.X, face.BackLowerRight.X),
            Facing.Right => Math.Max(face.FrontUpperLeft.X, face.BackLowerRight.X),
            _ => -Math.Min(face.FrontUpperLeft.Y, face.BackLowerRight.Y),
        };

    private static double Width(ModelFace face) =>
        face.Facing is Facing.Back or Facing.Front
            ? face.BackLowerRight.X - face.FrontUpperLeft.X
            : face.FrontUpperLeft.Y - face.BackLowerRight.Y;
}
