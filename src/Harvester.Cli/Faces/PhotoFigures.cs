using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Net;
using System.Text;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Text;
using Harvester.Surveys.Faces;

namespace Harvester.Cli.Faces;

/// <summary>A survey's photographs as figures of a page, each with the cuboids of its model's faces drawn where its camera saw them.</summary>
internal sealed class PhotoFigures
{
    private const double NearClip = 0.05;
    private static readonly ImageSize Shown = new(320, 320);
    private readonly string _folder;

    /// <summary>Looks for photographs.</summary>
    /// <param name="folder">The folder of the table.</param>
    public PhotoFigures(string folder)
    {
        _folder = Path.Combine(folder, SurveyPhoto.FolderName);
        Photos = [.. SurveyPhoto.ReadAll(folder).Where(photo => File.Exists(Path.Combine(_folder, photo.File)))];
    }

    /// <summary>The photographs that are there.</summary>
    public IReadOnlyList<SurveyPhoto> Photos { get; }

    /// <summary>The figures of a model.</summary>
    public string Of(string model, IReadOnlyList<ModelFace> faces)
    {
        var figures = new StringBuilder();
        foreach (SurveyPhoto photo in Photos.Where(photo => photo.Model == model))
        {
            string picture = Convert.ToBase64String(File.ReadAllBytes(Path.Combine(_folder, photo.File)));
            figures
                .Append(CultureInfo.InvariantCulture, $"<svg class=\"photo\" width=\"{Shown.Width}\" height=\"{Shown.Height}\"><title>{WebUtility.HtmlEncode(photo.File)}</title>")
                .Append(CultureInfo.InvariantCulture, $"<image width=\"{Shown.Width}\" height=\"{Shown.Height}\" href=\"data:image/png;base64,{picture}\"/>")
                .AppendJoin(string.Empty, faces.Select(face => Edges(photo, face)))
                .Append("</svg>");
        }

        return figures.ToString();
    }

    /// <summary>The edges of a face's cuboid; apart from them those that both of their sides turn away from the camera.</summary>
    private static string Edges(SurveyPhoto photo, ModelFace face)
    {
        var camera = new Camera(photo.Camera, new CameraIntrinsics(photo.VerticalFovDegrees, Shown, Shown.Aspect, NearClip, Lens.Ideal));
        Cuboid cuboid = face.CuboidAt(new Pose(Vector3D.Zero, Axes.Identity));
        string kind = JsonName.Of(face.Provenance);
        ILookup<bool, (Vector3D Start, Vector3D End)> edges = cuboid.EdgesInWorld.ToLookup(edge => IsHidden(cuboid, (edge.Start + edge.End) * 0.5, photo.Camera.Position));
        return Drawn(kind, edges[false], camera) + Drawn($"{kind} hidden", edges[true], camera);
    }

    private static string Drawn(string kind, IEnumerable<(Vector3D Start, Vector3D End)> edges, Camera camera)
    {
        IEnumerable<string> lines = edges
            .Select(edge => (Start: camera.Project(edge.Start), End: camera.Project(edge.End)))
            .Where(line => line.Start.Outcome != ProjectionOutcome.BehindNearPlane && line.End.Outcome != ProjectionOutcome.BehindNearPlane)
            .Select(line => string.Create(CultureInfo.InvariantCulture, $"M{line.Start.U:0.#},{line.Start.V:0.#}L{line.End.U:0.#},{line.End.V:0.#}"));
        return $"<path class=\"{kind}\" fill=\"none\" stroke=\"#f0f\" d=\"{string.Concat(lines)}\"/>";
    }

    /// <summary>Whether a point sees neither of the two sides that meet in an edge. The cuboid's axes are the world's.</summary>
    private static bool IsHidden(Cuboid cuboid, Vector3D middleOfEdge, Vector3D eye)
    {
        // The middle of an edge lies on two sides, and between the ends of the third axis.
        Vector3D edge = middleOfEdge - cuboid.Centre;
        Vector3D seen = eye - cuboid.Centre;
        Vector3D half = cuboid.HalfExtents;
        return !Sees(edge.X, seen.X, half.X) && !Sees(edge.Y, seen.Y, half.Y) && !Sees(edge.Z, seen.Z, half.Z);
    }

    // The two sides of a flat face are one, which is seen from wherever it is not edge-on.
    private static bool Sees(double side, double eye, double half) =>
        half == 0 ? eye != 0 : Math.Abs(side) > half / 2 && Math.Abs(eye) > half && Math.Sign(side) == Math.Sign(eye);
}
