using System.Diagnostics;
using System.Globalization;
using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Bridge;

namespace Harvester.Capture.Tests.Driving.Bridge;

public sealed class KilledPeerTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-killed").FullName;

    [UnixFact]
    [Trait("Category", "Heavy")]
    public void Folder_survives_a_peer_whose_process_is_killed_and_restarted_100_times()
    {
        using var bridge = new FolderBridge(_folder, Frames.Size);
        var random = new Random(9);
        for (int life = 1; life <= 100; life++)
        {
            using Process peer = Start(life);
            AwaitWordOf(bridge, life);
            bridge.Publish(Frames.State(life), Frames.Picture((byte)life));

            // It dies in the middle of whatever it does just then.
            Thread.Sleep(random.Next(5));
            peer.Kill();
            peer.WaitForExit();
        }

        string last = Path.Combine(_folder, "frame_00000100.png");
        Frames.Await(() => File.Exists(last), last);
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    /// <summary>A peer that writes its file without end, every other time not as a whole.</summary>
    private Process Start(int life)
    {
        string words = string.Create(CultureInfo.InvariantCulture, $"0.25 0.5 0 {life}");
        var start = new ProcessStartInfo("/bin/sh") { WorkingDirectory = _folder };
        start.ArgumentList.Add("-c");
        start.ArgumentList.Add($"while :; do echo '{words}' > part; mv part controls.txt; printf '0.25 ' > controls.txt; echo '0.5 0 {life}' >> controls.txt; done");
        return Process.Start(start)!;
    }

    private static void AwaitWordOf(FolderBridge bridge, int life)
    {
        Frames.Await(
            () =>
            {
                while (bridge.TryReceive(out PeerMessage? message))
                {
                    if (message == new ControlsMessage(new DrivingControls(0.25, 0.5, 0), life))
                    {
                        return true;
                    }
                }

                return false;
            },
            $"a word of life {life}; the bridge says: {bridge.Problem}");
    }
}
