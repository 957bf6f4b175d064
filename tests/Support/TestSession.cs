using System.Text.Json.Nodes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;

namespace Harvester.TestSupport;

/// <summary>
/// A good session of three frames with a car and a pedestrian each, written out by hand as docs/dataset-format.md describes it,
/// for tests to damage.
/// </summary>
internal sealed class TestSession : IDisposable
{
    public const int Width = 80;
    public const int Height = 60;

    public TestSession()
    {
        Directory.CreateDirectory(PathOf("frames"));
        Directory.CreateDirectory(PathOf("masks"));
        for (int frame = 0; frame < 3; frame++)
        {
            Lines.Add(Frame(frame));
            File.WriteAllBytes(PathOf($"frames/{frame:D8}.png"), TestImages.Png(Width, Height));
            PaintMask(frame, 1, 38, 28, 43, 33);
        }

        Info = JsonNode
            .Parse(
                $$"""
                {
                  "formatVersion": 1, "game": "simulation", "seed": 7, "image": { "width": {{Width}}, "height": {{Height}}, "format": "png" },
                  "state": "complete", "fault": null, "counters": { "captured": 3 }
                }
                """
            )!
            .AsObject();
    }

    public string Folder { get; } = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    /// <summary>The content of session.json.</summary>
    public JsonObject Info { get; }

    /// <summary>The lines of labels.jsonl.</summary>
    public List<JsonObject> Lines { get; } = [];

    public JsonObject Car(int line) => Lines[line]["objects"]![0]!.AsObject();

    public string PathOf(string name) => Path.Combine(Folder, name);

    /// <summary>The pedestrian, with unknown occlusion.</summary>
    public JsonObject Pedestrian(int line) => Lines[line]["objects"]![1]!.AsObject();

    /// <summary>Sets the pedestrian of every frame to not occluded.</summary>
    public void DeterminePedestrians()
    {
        foreach (JsonObject pedestrian in Lines.Select(line => line["objects"]![1]!.AsObject()))
        {
            pedestrian["box2dVisible"] = new JsonArray(70, 24, 80, 36);
            pedestrian["occludedFraction"] = 0;
            pedestrian["occlusionMethod"] = "rays";
            pedestrian["visibleFraction"] = 0.8;
        }
    }

    /// <summary>
    /// Gives the pedestrian of every frame joints, 5 m ahead, where a metre is 6 pixels: facing the camera, with the person's right at the
    /// left. The right elbow is hidden by the person, the left knee by something else.
    /// </summary>
    public void AddJoints()
    {
        // Metres to the person's left and upward of the middle, in the order of JTA.
        (double Left, double Up)[] places =
        [
            (0, 0.95),
            (0, 0.8),
            (0, 0.65),
            (-0.05, 0.6),
            (-0.2, 0.58),
            (-0.25, 0.3),
            (-0.25, 0),
            (0.05, 0.6),
            (0.2, 0.58),
            (0.25, 0.3),
            (0.25, 0),
            (0, 0.45),
            (0, 0.35),
            (0, 0.25),
            (0, 0.15),
            (0, 0.05),
            (-0.1, 0),
            (-0.1, -0.45),
            (-0.1, -0.85),
            (0.1, 0),
            (0.1, -0.45),
            (0.1, -0.85),
        ];
        foreach (JsonObject pedestrian in Lines.Select(line => line["objects"]![1]!.AsObject()))
        {
            pedestrian["box2dJoints"] = new JsonArray(60, 20, 95, 40);
            pedestrian["joints"] = new JsonArray([
                .. places.Select(
                    (place, number) =>
                        (JsonNode)
                            new JsonObject
                            {
                                ["joint"] = JointNames.All[number],
                                ["position"] = new JsonArray(6 + place.Left, 5, place.Up),
                                ["pixel"] = new JsonArray(Math.Round(76 + (6 * place.Left), 3), Math.Round(30 - (6 * place.Up), 3)),
                                ["visibility"] = (Joint)number switch
                                {
                                    Joint.RightElbow => "selfOccluded",
                                    Joint.LeftKnee => "occluded",
                                    _ => "visible",
                                },
                            }
                ),
            ]);
        }
    }

    /// <summary>Writes a mask that shows one rectangle of a number and nothing else.</summary>
    public void PaintMask(int frame, ushort id, int left, int top, int right, int bottom) =>
        PaintMask(frame, (id, left, top, right, bottom));

    /// <summary>Writes a mask that shows rectangles of numbers, the later ones over the earlier, and nothing else.</summary>
    public void PaintMask(int frame, params (ushort Id, int Left, int Top, int Right, int Bottom)[] rectangles)
    {
        var map = new InstanceMap(new ImageSize(Width, Height));
        foreach ((ushort id, int left, int top, int right, int bottom) in rectangles)
        {
            for (int row = top; row < bottom; row++)
            {
                for (int column = left; column < right; column++)
                {
                    map[column, row] = id;
                }
            }
        }

        using FileStream file = File.Create(PathOf($"masks/{frame:D8}.png"));
        new PngEncoder().Write(map, file);
    }

    /// <summary>Writes the session in its current state and opens it.</summary>
    public SessionReader Open()
    {
        File.WriteAllText(PathOf("session.json"), Info.ToJsonString());
        return OpenWithLabels(string.Concat(Lines.Select(line => line.ToJsonString() + "\n")));
    }

    /// <summary>As <see cref="Open"/>, with other text for the labels.</summary>
    public SessionReader OpenWithLabels(string labels)
    {
        File.WriteAllText(PathOf("session.json"), Info.ToJsonString());
        File.WriteAllText(PathOf("labels.jsonl"), labels);
        return new SessionReader(Folder);
    }

    public void Dispose() => Directory.Delete(Folder, recursive: true);

    /// <summary>
    /// Puts a stop sign on a post into a frame, with its face as a part. 6 m ahead a metre is 30 / 6 = 5 pixels: the face, 2 m wide and
    /// high around (-4, 2), is in columns 40 - 25 to 40 - 15 and rows 30 - 15 to 30 - 5, and the post below it, 0.4 m wide, in columns 19
    /// and 20 down to row 40.
    /// </summary>
    public void AddSign(int line)
    {
        JsonArray objects = Lines[line]["objects"]!.AsArray();
        objects.Add(
            JsonNode.Parse(
                """
                {
                  "id": 3, "class": "sign", "model": "prop_sign_road_01a", "name": null, "parent": null, "knownParts": 1, "hasRider": null,
                  "box2d": [15, 15, 25, 40], "box2dAmodal": [15, 15, 25, 40], "box2dVisible": [15, 15, 25, 40],
                  "truncatedFraction": 0, "occludedFraction": 0, "occlusionMethod": "pixelMap", "visibleFraction": 1,
                  "box3d": { "centre": [-4, 6, 0.5], "halfExtents": [1, 0.05, 2.5], "right": [1, 0, 0], "forward": [0, 1, 0], "up": [0, 0, 1] },
                  "distanceMetres": 7.228416, "velocity": [0, 0, 0], "space": null
                }
                """
            )
        );
        objects.Add(
            JsonNode.Parse(
                """
                {
                  "id": 4, "class": "sign", "model": "prop_sign_road_01a", "name": "STOP", "parent": 3, "knownParts": null, "hasRider": null,
                  "box2d": [15, 15, 25, 25], "box2dAmodal": [15, 15, 25, 25], "box2dVisible": null,
                  "truncatedFraction": 0, "occludedFraction": 0, "occlusionMethod": "rays", "visibleFraction": 1,
                  "box3d": { "centre": [-4, 6, 2], "halfExtents": [1, 0.005, 1], "right": [1, 0, 0], "forward": [0, 1, 0], "up": [0, 0, 1] },
                  "distanceMetres": 7.483315, "velocity": [0, 0, 0],
                  "space": { "face": 0, "mutcd": "R1-1", "facesCamera": true, "facingAngleDegrees": 20, "provenance": "measured", "light": null }
                }
                """
            )
        );
        PaintMask(line, (1, 38, 28, 43, 33), (3, 15, 15, 25, 25), (3, 19, 25, 21, 40));
    }

    // The camera stands at the origin and looks north: fy = 60 / (2 tan 45°) = 30, fx = 80 / (2 tan 45° · 4/3) = 30.
    private static JsonObject Frame(int frame) =>
        JsonNode
            .Parse(
                $$"""
                {
                  "frame": {{frame}}, "gameFrame": {{100 + frame}}, "timeSeconds": {{frame}}.5, "lagFrames": 0, "lagSeconds": 0,
                  "image": "frames/{{frame:D8}}.png", "mask": "masks/{{frame:D8}}.png",
                  "pixelMap": { "resolutionPixels": 1, "interpolatedPixels": 90, "raysCast": 70 },
                  "camera": {
                    "position": [0, 0, 0], "right": [1, 0, 0], "forward": [0, 1, 0], "up": [0, 0, 1], "verticalFovDegrees": 90,
                    "width": 80, "height": 60, "windowAspect": 1.3333333333333333, "nearClip": 0.15, "fx": 30, "fy": 30, "cx": 40, "cy": 30,
                    "distortion": { "focalScale": 1, "k1": 0, "k2": 0 }
                  },
                  "ego": { "position": [0, -2, -1], "headingDegrees": 0, "velocity": [0, 10, 0], "model": "adder" },
                  "environment": { "weather": "clear", "timeOfDay": "13:05:00" },
                  "objects": [
                    {
                      "id": 1, "class": "car", "model": "blista", "name": null,
                      "box2d": [37, 27, 43, 33], "box2dAmodal": [37, 27, 43, 33], "box2dVisible": [38, 28, 43, 33],
                      "truncatedFraction": 0, "occludedFraction": 0.25, "occlusionMethod": "rays", "visibleFraction": 0.75,
                      "box3d": { "centre": [0, 11, 0], "halfExtents": [1, 1, 1], "right": [1, 0, 0], "forward": [0, 1, 0], "up": [0, 0, 1] },
                      "distanceMetres": 11, "velocity": [0, 5, 0]
                    },
                    {
                      "id": 2, "class": "pedestrian", "model": "a_m_y_hipster_01", "name": null,
                      "box2d": [70, 24, 80, 36], "box2dAmodal": [70, 24, 82, 36], "box2dVisible": null,
                      "truncatedFraction": 0.2, "occludedFraction": null, "occlusionMethod": "none", "visibleFraction": null,
                      "box3d": { "centre": [6, 5, 0], "halfExtents": [1, 0, 1], "right": [1, 0, 0], "forward": [0, 1, 0], "up": [0, 0, 1] },
                      "distanceMetres": 7.810249675906654, "velocity": [0, 0, 0]
                    }
                  ]
                }
                """
            )!
            .AsObject();
}
