using System.Text;
using System.Text.Json.Nodes;
using Harvester.Exports.Formats.Mcap;
using Harvester.Exports.Validation;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Tests.Mcap;

/// <summary>The channels of recorded drives, with actions written by hand.</summary>
public sealed class McapDriveTests : ExportTests
{
    private const string File = "out/train/0000.mcap";

    [Fact]
    public void Session_without_a_drive_has_no_channel_of_drives()
    {
        Folder.Export("mcap", Session.Open());

        string text = Encoding.Latin1.GetString(Content());
        Assert.DoesNotContain("/drive/", text, StringComparison.Ordinal);
        Assert.DoesNotContain("/imu", text, StringComparison.Ordinal);
        Assert.Contains("/indicators", text, StringComparison.Ordinal);
    }

    [Fact]
    public void Action_has_the_answer_and_what_was_applied()
    {
        Record(0, 1, 2);
        Folder.Export("mcap", Session.Open());

        ProtoFields action = Assert.Single(Messages("/drive/action"), message => message.Sequence == 1).Fields;
        Assert.Equal(Math.Round(Time(1) * 1e9), action.Nanoseconds(1));
        Assert.Equal("controller", action.Text(2));
        Assert.Equal([0.25, 0.5, 0], action.Numbers(3, 3));
        Assert.True(action.Has(4));
        Assert.Equal([0.125, 0.5, 0], action.Numbers(5, 3));
        Assert.Equal([1, 12.5, 7], [action.Number(6), action.Number(8), action.Number(9)]);
        Assert.Equal("left", action.Text(7));
    }

    [Fact]
    public void Answered_indicators_keep_their_order()
    {
        Record(0, 1, 2);
        Folder.Export("mcap", Session.Open());

        ProtoFields indicators = Messages("/drive/indicators")[0].Fields;
        Assert.Equal(Enumerable.Range(0, 13).Select(i => i / 8.0), Enumerable.Range(2, 13).Select(indicators.Number));
        Assert.Equal(7, indicators.Number(15));
    }

    [Fact]
    public void Unknown_values_are_absent()
    {
        Record(0, 1, 2);
        JsonNode drive = Session.Lines[0]["drive"]!;
        drive["controls"] = drive["applied"] = drive["answerSeconds"] = drive["route"] = drive["routeMetres"] = drive["indicators"] = null;
        drive["ticks"]![0]!["applied"] = drive["ticks"]![0]!["angularRate"] = null;
        Folder.Export("mcap", Session.Open());

        ProtoFields action = Messages("/drive/action")[0].Fields;
        Assert.All([3, 4, 5, 7, 8], field => Assert.False(action.Has(field)));
        Assert.Equal(2, Messages("/drive/indicators").Count);
        Assert.False(Messages("/drive/tick")[0].Fields.Has(4));
        Assert.Equal(5, Messages("/imu").Count);
    }

    [Fact]
    public void Ticks_have_their_own_time_and_directions_of_the_ego()
    {
        Record(0, 1, 2);
        Folder.Export("mcap", Session.Open());

        (ulong time, uint sequence, ProtoFields imu) = Messages("/imu")[1];
        Assert.Equal((ulong)Math.Round((Time(0) + 0.1) * 1e9), time);
        Assert.Equal(time, imu.Nanoseconds(1));
        Assert.Equal(0u, sequence);
        Assert.Equal("ego", imu.Text(2));

        // Right, forward, up 0.5, 0.25, -1 is x forward 0.25, y left -0.5, z up -1.
        Assert.Equal([0.25, -0.5, -1], imu.Numbers(3, 3));
        Assert.Equal([2, -1, 3], imu.Numbers(4, 3));
        ProtoFields tick = Messages("/drive/tick")[1].Fields;
        Assert.Equal(time, tick.Nanoseconds(1));
        Assert.Equal("builtIn", tick.Text(2));
        Assert.Equal(8, tick.Number(3));
        Assert.Equal([0.125, 0, 1], tick.Numbers(4, 3));
    }

    [Fact]
    public void Channels_are_defined_before_their_first_message()
    {
        // Only the second frame has an action.
        Record(1);
        Folder.Export("mcap", Session.Open());

        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
        HashSet<int> defined = [];
        foreach ((_, byte kind, byte[] content) in McapRecords.Of(Content()))
        {
            if (kind == 4)
            {
                defined.Add(BitConverter.ToUInt16(content));
            }
            else if (kind == 7)
            {
                Assert.Contains(BitConverter.ToUInt16(content), defined);
            }
        }

        Assert.Equal(McapChannel.OfSessions.Length + McapChannel.OfDrives.Length, defined.Count);
        Assert.Equal(2, Messages("/imu").Count);
    }

    [Fact]
    public void Tick_before_its_frame_is_refused()
    {
        Record(0, 1, 2);
        Session.Lines[1]["drive"]!["ticks"]![0]!["timeSeconds"] = -5;

        DatasetFormatException e = Assert.Throws<DatasetFormatException>(() => Folder.Export("mcap", Session.Open()));
        Assert.Contains("a tick after it has an earlier time", e.Message, StringComparison.Ordinal);
    }

    private void Record(params int[] frames)
    {
        foreach (int frame in frames)
        {
            string time = Time(frame).ToString("R", null);
            string later = (Time(frame) + 0.1).ToString("R", null);
            Session.Lines[frame]["drive"] = JsonNode.Parse(
                $$"""
                {
                  "driver": "controller", "controls": { "steering": 0.25, "throttle": 0.5, "brake": 0 }, "answerSeconds": 0,
                  "applied": { "steering": 0.125, "throttle": 0.5, "brake": 0 }, "disturbed": true,
                  "indicators": [0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1, 1.125, 1.25, 1.375, 1.5],
                  "route": "left", "routeMetres": 12.5, "speed": 7, "acceleration": null, "angularRate": null, "bridgeFrame": null,
                  "truth": null,
                  "ticks": [
                    { "timeSeconds": {{time}}, "driver": "controller", "speed": 7.5, "acceleration": [0, 1, 0],
                      "angularRate": [0, 0, 0], "applied": { "steering": 0.125, "throttle": 0.5, "brake": 0 } },
                    { "timeSeconds": {{later}}, "driver": "builtIn", "speed": 8, "acceleration": [1, 2, 3],
                      "angularRate": [0.5, 0.25, -1], "applied": { "steering": 0.125, "throttle": 0, "brake": 1 } }
                  ]
                }
                """
            );
        }
    }

    private double Time(int frame) => (double)Session.Lines[frame]["timeSeconds"]!;

    private byte[] Content() => System.IO.File.ReadAllBytes(Folder.PathOf(File));

    private List<(ulong Time, uint Sequence, ProtoFields Fields)> Messages(string topic)
    {
        int id = McapChannel.All.Single(channel => channel.Topic == topic).Id;
        return
        [
            .. McapRecords
                .Messages(Content())
                .Where(message => message.Channel == id)
                .Select(message => (message.Time, message.Sequence, new ProtoFields(message.Content))),
        ];
    }
}
