using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Pages;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Faces;

/// <summary>
/// The photographs of a survey as figures of a page, with the cuboids of the faces projected onto them.
/// </summary>
internal sealed class PhotoFigures
{
    private const double NearClip = 0.05;
    private static readonly ImageSize Shown = new(320, 320);
    private readonly string _folder;
    private readonly EmbeddedPictures _pictures;

    /// <summary>Lists the photographs of a survey.</summary>
    /// <param name="folder">The folder of the table.</param>
    /// <param name="pictures">Reads the images.</param>
    public PhotoFigures(string folder, EmbeddedPictures pictures)
    {
        _folder = Path.Combine(folder, SurveyPhoto.FolderName);
        _pictures = pictures;
        string table = Path.Combine(folder, SurveyPhoto.TableName);
        using TextReader text = File.Exists(table) ? InputFile.OpenText(table) : TextReader.Null;
        Photos =
        [
            .. SurveyPhoto
                .ReadAll(text)
                .Where(photo => InnerPath.IsWithin(_folder, photo.File) && File.Exists(InnerPath.Of(_folder, photo.File))),
        ];
    }

    /// <summary>The photographs that exist.</summary>
    public IReadOnlyList<SurveyPhoto> Photos { get; }

    /// <summary>Writes the photographs of a model as svg elements.</summary>
    public void Write(MarkupWriter page, string model, IReadOnlyList<ModelFace> faces)
    {
        foreach (SurveyPhoto photo in Photos.Where(photo => photo.Model == model))
        {
            page.Start("svg").With("class", "photo").With("width", Shown.Width).With("height", Shown.Height).Element("title", photo.File);
            page.Start("image").With("width", Shown.Width).With("height", Shown.Height);
            page.WithData("href", "image/png", _pictures.Read(_folder, photo.File)).End();
            foreach (ModelFace face in faces)
            {
                WriteEdges(page, photo, face);
            }

            page.End();
        }
    }

    /// <summary>Writes the edges of a face's cuboid: one path for the visible and one for the hidden edges.</summary>
    private static void WriteEdges(MarkupWriter page, SurveyPhoto photo, ModelFace face)
    {
        var camera = new Camera(photo.Camera, new CameraIntrinsics(photo.VerticalFovDegrees, Shown, Shown.Aspect, NearClip, Lens.Ideal));
        Cuboid cuboid = face.CuboidAt(new Pose(Vector3D.Zero, Axes.Identity));
        string kind = JsonName.Of(face.Provenance);
        ILookup<bool, (Vector3D Start, Vector3D End)> edges = cuboid.EdgesInWorld.ToLookup(edge =>
            IsHidden(cuboid, (edge.Start + edge.End) * 0.5, photo.Camera.Position)
        );
        WriteEdges(page, kind, edges[false], camera);
        WriteEdges(page, $"{kind} hidden", edges[true], camera);
    }

    private static void WriteEdges(MarkupWriter page, string style, IEnumerable<(Vector3D Start, Vector3D End)> edges, Camera camera)
    {
        IEnumerable<Vector2D[]> lines = edges
            .Select(edge => (Start: camera.Project(edge.Start), End: camera.Project(edge.End)))
            .Where(line => line.Start.Outcome != ProjectionOutcome.BehindNearPlane && line.End.Outcome != ProjectionOutcome.BehindNearPlane)
            .Select(line => new[] { line.Start.Pixel, line.End.Pixel });
        page.Start("path").With("class", style).With("fill", "none").With("stroke", "#f0f").WithLines(lines).End();
    }

    /// <summary>Whether neither of the two sides that meet in an edge is visible from a point. The cuboid is axis-aligned.</summary>
    private static bool IsHidden(Cuboid cuboid, Vector3D middleOfEdge, Vector3D eye)
    {
        // The middle of an edge lies on two sides of the cuboid, and at the middle of the third axis.
        Vector3D edge = middleOfEdge - cuboid.Centre;
        Vector3D seen = eye - cuboid.Centre;
        Vector3D half = cuboid.HalfExtents;
        return !Sees(edge.X, seen.X, half.X) && !Sees(edge.Y, seen.Y, half.Y) && !Sees(edge.Z, seen.Z, half.Z);
    }

    // The two sides of a flat face coincide and are visible unless they are edge-on.
    private static bool Sees(double side, double eye, double half) =>
        half == 0 ? eye != 0 : Math.Abs(side) > half / 2 && Math.Abs(eye) > half && Math.Sign(side) == Math.Sign(eye);
}
