using System.Text.Json;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Storage;

public sealed class SessionJsonTests
{
    private static readonly SessionRecord Recording = new(
        new SessionOrigin
        {
            Game = "simulation",
            Tool = "harvester 1.0",
            Seed = 5,
            Settings = [new("weather", "rain")],
        },
        new SessionStart(
            new HarvestOptions { Image = new ImageSize(100, 100), Classes = [ObjectClass.Bus, ObjectClass.Car] },
            7,
            0.125,
            new CameraState(new Pose(new Vector3D(1, 2, 3), Axes.Identity), 90, 0.15, 1)
        ),
        null,
        0,
        HasManifest: true
    );

    [Fact]
    public void Truth_says_what_is_exact_and_what_is_estimated()
    {
        string text = SessionJson.Text(
            Recording with
            {
                Origin = Recording.Origin with { Truth = LabelTruths.OfSimulation(hasTrueOcclusion: true) },
            }
        );

        using var document = JsonDocument.Parse(text);
        JsonElement truth = document.RootElement.GetProperty("truth");
        Assert.Equal("exact", truth.GetProperty("joints").GetString());
        Assert.Equal("exact", truth.GetProperty("trueOcclusion").GetString());
        Assert.Equal("estimated", truth.GetProperty("occlusion").GetString());
        Assert.Equal(LabelTruths.OfGame.Select(label => label.Key), truth.EnumerateObject().Select(property => property.Name));
        Assert.DoesNotContain("truth", SessionJson.Text(Recording), StringComparison.Ordinal);
    }

    [Fact]
    public void Text_of_a_finished_session_is_as_documented()
    {
        SessionRecord finished = Recording with
        {
            End = new SessionEnd(99, 1.5, 3, [new("covered", 2), new("neverStill", 1)], [new(0, 3), new(2, 1)], new PictureLag(1, 2), null),
            FramesWritten = 3,
        };
        string version = typeof(SessionJson).Assembly.GetName().Version!.ToString(3);

        Assert.Equal(
            $$"""
            {
              "formatVersion": 1,
              "tool": "harvester 1.0",
              "captureVersion": "{{version}}",
              "game": "simulation",
              "seed": 5,
              "settings": {
                "weather": "rain"
              },
              "image": {
                "width": 100,
                "height": 100,
                "format": "png",
                "quality": null
              },
              "boxes": {
                "visible": "box2dVisible",
                "amodal": "box2dAmodal",
                "cuboid": "box2d"
              },
              "options": {
                "rateHz": 10,
                "rangeMetres": 150,
                "ignoreRangeMetres": 300,
                "freeze": true,
                "freezeBy": "paused",
                "masks": false,
                "semantics": null,
                "scenes": true,
                "rayBudget": 50000,
                "rayReachMetres": 1000,
                "minBoxAreaPixels": 16,
                "minBoxSidePixels": 2,
                "maxOccludedFraction": 0.99,
                "occlusionSamples": 64,
                "maxPictureLagTicks": 4,
                "maxSettleTicks": 60,
                "stillToleranceMetres": 0.001
              },
              "classes": ["car", "bus"],
              "start": {
                "gameFrame": 7,
                "timeSeconds": 0.125,
                "recordedUtc": null,
                "cameraErrorPixels": null
              },
              "camera": {
                "position": [1, 2, 3],
                "right": [1, 0, 0],
                "forward": [0, 1, 0],
                "up": [0, 0, 1],
                "verticalFovDegrees": 90,
                "width": 100,
                "height": 100,
                "windowAspect": 1,
                "nearClip": 0.15,
                "fx": 50,
                "fy": 50,
                "cx": 50,
                "cy": 50,
                "distortion": {
                  "focalScale": 1,
                  "k1": 0,
                  "k2": 0
                }
              },
              "state": "complete",
              "fault": null,
              "manifest": true,
              "end": {
                "gameFrame": 99,
                "timeSeconds": 1.5
              },
              "counters": {
                "captured": 3,
                "discarded": 3,
                "discards": {
                  "covered": 2,
                  "neverStill": 1
                },
                "settleTicks": {
                  "0": 3,
                  "2": 1
                }
              },
              "pictureLag": {
                "cameraTicks": 1,
                "entityTicks": 2
              }
            }

            """.ReplaceLineEndings("\n"),
            SessionJson.Text(finished)
        );
    }

    [Fact]
    public void Text_records_the_freeze_trials_and_their_outcomes()
    {
        FreezeReport freezing = FreezeReport.Of([
            new FreezeFinding(FreezeMethod.Paused, true, null),
            new FreezeFinding(FreezeMethod.TimeScale, false, 3)
            {
                HoldsEnvironment = false,
                MovesCamera = true,
                PictureChange = 0.12345,
            },
        ]);
        string text = SessionJson.Text(
            Recording with
            {
                Start = Recording.Start with { Options = Recording.Start.Options with { FreezeBy = null }, Freezing = freezing },
            }
        );

        JsonElement json = JsonDocument.Parse(text).RootElement;
        Assert.Equal("auto", json.GetProperty("options").GetProperty("freezeBy").GetString());
        JsonElement start = json.GetProperty("start").GetProperty("freezing");
        Assert.Equal("timeScale", start.GetProperty("used").GetString());
        Assert.Equal(
            [
                """{"method":"paused","sawMovement":true,"settleTicks":null,"holdsEnvironment":null,"movesCamera":null"""
                    + ""","pictureChange":null}""",
                """{"method":"timeScale","sawMovement":false,"settleTicks":3,"holdsEnvironment":false,"movesCamera":true"""
                    + ""","pictureChange":0.1235}""",
            ],
            start.GetProperty("tried").EnumerateArray().Select(tried => JsonSerializer.Serialize(tried))
        );
    }

    [Fact]
    public void Text_records_how_well_the_game_was_read_when_known()
    {
        var end = new SessionEnd(99, 1.5, 3, [], [], null, null)
        {
            Reading = new ReadingReport(ListSource.Api, ListSource.Natives, ListSource.Api, 2),
        };

        Assert.EndsWith(
            ",\n  \"reading\": {\n    \"vehicles\": \"api\",\n    \"peds\": \"natives\",\n    \"props\": \"api\",\n    "
                + "\"distortedEntities\": 2\n  }\n}\n",
            SessionJson.Text(Recording with { End = end }),
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Text_while_it_is_recorded_ends_with_its_state() =>
        Assert.EndsWith("},\n  \"state\": \"recording\"\n}\n", SessionJson.Text(Recording), StringComparison.Ordinal);

    [Fact]
    public void Text_after_a_fault_names_it()
    {
        var end = new SessionEnd(99, 1.5, 3, [], [], null, "The disk is full.");

        Assert.Contains(
            "\"state\": \"faulted\",\n  \"fault\": \"The disk is full.\",\n",
            SessionJson.Text(Recording with { End = end }),
            StringComparison.Ordinal
        );
    }
}
