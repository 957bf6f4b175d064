using System.Text.Json.Nodes;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Sessions.Tests.Reading;

public sealed class SessionReaderTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void ReadLabels_gives_every_field()
    {
        FrameLabel label = _session.Open().ReadLabels().ElementAt(1);

        Assert.Equal(1, label.Frame);
        Assert.Equal(101, label.GameFrame);
        Assert.Equal(1.5, label.TimeSeconds);
        Assert.Equal("frames/00000001.png", label.Image);
        Assert.Equal("masks/00000001.png", label.Mask);
        Assert.Equal(new PixelMapLabel(1, 90, 70), label.PixelMap);
        Assert.Equal(new Pose(Vector3D.Zero, Axes.Identity), label.Camera.Pose);
        Assert.Equal(
            (90, 80, 60, 30, 30, 40, 30),
            (
                label.Camera.VerticalFovDegrees,
                label.Camera.Width,
                label.Camera.Height,
                label.Camera.Fx,
                label.Camera.Fy,
                label.Camera.Cx,
                label.Camera.Cy
            )
        );
        Assert.Equal(new DistortionLabel(1, 0, 0), label.Camera.Distortion);
        Assert.Equal(new EgoLabel(new(0, -2, -1), 0, new(0, 10, 0), "adder"), label.Ego);
        Assert.Equal(new EnvironmentState("clear", new TimeSpan(13, 5, 0)), label.Environment);

        ObjectLabel car = label.Objects[0];
        Assert.Equal((1, ObjectClass.Car, "blista", null), (car.Id, car.Class, car.Model, car.Name));
        Assert.Equal(new Box2D(37, 27, 43, 33), car.Box2D);
        Assert.Equal(new Box2D(37, 27, 43, 33), car.Box2DAmodal);
        Assert.Equal(new Box2D(38, 28, 43, 33), car.Box2DVisible);
        Assert.Equal((0.0, 0.25, OcclusionMethod.Rays), (car.TruncatedFraction, car.OccludedFraction, car.OcclusionMethod));
        Assert.Equal(new Vector3D(0, 11, 0), car.Box3D.Centre);
        Assert.Equal(new Vector3D(1, 1, 1), car.Box3D.HalfExtents);
        Assert.Equal(11, car.DistanceMetres);
        Assert.Equal(new Vector3D(0, 5, 0), car.Velocity);
    }

    [Fact]
    public void ReadLabels_keeps_what_was_not_determined_as_null()
    {
        ObjectLabel pedestrian = _session.Open().ReadLabels().First().Objects[1];

        Assert.Null(pedestrian.OccludedFraction);
        Assert.Null(pedestrian.Box2DVisible);
    }

    [Theory]
    [InlineData("", false, 0)]
    [InlineData("{}", true, 0)]
    [InlineData("{}\n", false, 1)]
    [InlineData("{}\n{}\n{\"frame\"", true, 2)]
    public void ReadLines_ignores_an_unfinished_last_line(string labels, bool isUnfinished, int lines)
    {
        SessionReader reader = _session.OpenWithLabels(labels);

        Assert.Equal((isUnfinished, lines, lines), (reader.HasUnfinishedLine, reader.CountLines(), reader.ReadLines().Count()));
    }

    [Fact]
    public void ReadLabels_ignores_fields_of_later_versions()
    {
        _session.Lines[0]["somethingNew"] = new JsonObject { ["a"] = 1 };

        Assert.Equal(3, _session.Open().ReadLabels().Count());
    }

    [Theory]
    [InlineData("frame", "\"one\"", "frame must be a whole number, not \"one\".")]
    [InlineData("frame", "1.5", "frame must be a whole number, not 1.5.")]
    [InlineData("frame", "3000000000", "frame must be a 32-bit whole number")]
    [InlineData("timeSeconds", "1e999", "timeSeconds must be a finite number")]
    [InlineData("image", "7", "image must be a text, not 7.")]
    [InlineData("camera", "[]", "camera must be an object, not [].")]
    [InlineData("objects", "{}", "objects must be a list of objects, not {}.")]
    [InlineData("objects", "[1]", "objects[0] must be an object, not 1.")]
    [InlineData("environment", """{ "weather": "clear", "timeOfDay": "noon" }""", "environment.timeOfDay must be a time")]
    public void ReadLabels_names_file_line_and_field_of_an_error(string field, string value, string message)
    {
        _session.Lines[1][field] = null;
        string labels = string.Concat(_session.Lines.Select(line => line.ToJsonString() + "\n"));
        SessionReader reader = _session.OpenWithLabels(
            labels.Replace($"\"{field}\":null", $"\"{field}\":{value}", StringComparison.Ordinal)
        );

        DatasetFormatException error = Assert.Throws<DatasetFormatException>(() => reader.ReadLabels().Count());

        Assert.StartsWith($"{_session.PathOf("labels.jsonl")}, line 2: {message}", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void ReadLabels_names_the_field_within_an_object()
    {
        _session.Car(2)["box3d"]!["halfExtents"] = JsonNode.Parse("[1, -1, 1]");

        DatasetFormatException error = Assert.Throws<DatasetFormatException>(() => _session.Open().ReadLabels().Count());

        Assert.StartsWith(
            $"{_session.PathOf("labels.jsonl")}, line 3: objects[0].box3d: A cuboid's half extents",
            error.Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void ReadLabels_of_invalid_axes_names_their_object()
    {
        _session.Lines[0]["camera"]!["up"] = JsonNode.Parse("[0, 0, -1]");

        DatasetFormatException error = Assert.Throws<DatasetFormatException>(() => _session.Open().ReadLabels().Count());

        Assert.StartsWith($"{_session.PathOf("labels.jsonl")}, line 1: camera: The axes must be", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void SessionReader_reports_a_missing_folder() =>
        Assert.Contains(
            "Folder not found",
            Assert.Throws<DirectoryNotFoundException>(() => new SessionReader("no-such-folder")).Message,
            StringComparison.Ordinal
        );

    [Fact]
    public void SessionReader_of_another_folder_names_the_missing_file() =>
        Assert.Contains(
            "no session.json",
            Assert.Throws<FileNotFoundException>(() => new SessionReader(_session.Folder)).Message,
            StringComparison.Ordinal
        );

    [Fact]
    public void ReadLabels_of_a_session_without_a_frame_is_empty()
    {
        _session.Open();
        File.Delete(_session.PathOf("labels.jsonl"));

        Assert.Empty(new SessionReader(_session.Folder).ReadLabels());
    }

    [Fact]
    public void ReadInfo_of_another_version_names_the_supported_one()
    {
        _session.Info["formatVersion"] = 2;

        DatasetFormatException error = Assert.Throws<DatasetFormatException>(() => _session.Open().ReadInfo());

        Assert.StartsWith("session.json: formatVersion is 2", error.Message, StringComparison.Ordinal);
    }
}
