using System.Diagnostics;
using System.Globalization;
using System.Text;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Files;

namespace Harvester.Runs.Clients;

/// <summary>
/// The client's side of a folder bridge: reads state.txt, writes controls.txt and command.json, each atomically. The state has no position,
/// heading or lane width; the width of ordinary roads is assumed. A state file that existed before is ignored.
/// </summary>
public sealed class FolderLink : IBridgeLink
{
    private const int MaxStateLength = 65_536;
    private static readonly int Values = IndicatorTable.Count + 4;
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(3);

    /// <summary>Time for which an operation is repeated if a file is open elsewhere or the disk fails briefly.</summary>
    private static readonly TimeSpan PatienceOfWriting = TimeSpan.FromSeconds(2);

    private readonly string _folder;
    private string? _seen;
    private bool _isHeard;
    private int _commands;

    /// <summary>Opens the folder.</summary>
    /// <param name="folder">The shared folder.</param>
    /// <exception cref="IOException">
    /// The folder does not exist or cannot be written to, or the game there speaks another version.
    /// </exception>
    public FolderLink(string folder)
    {
        _folder = Directory.Exists(folder)
            ? folder
            : throw new IOException($"Shared folder not found: '{folder}'. Start the game's side first; it creates the folder.");
        CheckVersion();
        _seen = ReadState();

        AskForFrame();
    }

    /// <summary>Another process may overwrite a file before the game has read it.</summary>
    public bool MayLose => true;

    /// <inheritdoc/>
    public ClientFrame? Receive(TimeSpan patience)
    {
        var waited = Stopwatch.StartNew();
        do
        {
            string? state = ReadState();
            if (state is not null && state != _seen && FrameOf(state) is { } frame)
            {
                if (!_isHeard)
                {
                    // The game may have begun after this client has.
                    CheckVersion();
                }

                _seen = state;
                _isHeard = true;
                return frame;
            }

            Thread.Sleep(Poll);
        } while (waited.Elapsed < patience);
        return null;
    }

    /// <inheritdoc/>
    public void Send(DrivingControls controls, long frame) =>
        WriteWhole(
            "controls.txt",
            FormattableString.Invariant($"{controls.Steering:0.######} {controls.Throttle:0.######} {controls.Brake:0.######} {frame}\n")
        );

    /// <summary>
    /// Requests a frame. Until the first frame has arrived, a hello does this; it also resumes a world that an earlier client has frozen.
    /// </summary>
    public void AskForFrame() => Command(_isHeard ? "{\"type\":\"requestFrame\"}" : Hello);

    /// <inheritdoc/>
    public void Step(double seconds) =>
        Command(string.Create(CultureInfo.InvariantCulture, $"{{\"type\":\"step\",\"seconds\":{seconds}}}"));

    /// <summary>There is nothing to release.</summary>
    public void Dispose() { }

    private static string Hello { get; } =
        string.Create(CultureInfo.InvariantCulture, $"{{\"type\":\"{BridgeProtocol.HelloType}\",\"version\":{BridgeProtocol.Version}}}");

    /// <summary>A game that names no version is taken for one of the same.</summary>
    private void CheckVersion()
    {
        try
        {
            if (Read(BridgeProtocol.HelloFile) is { } hello && BridgeProtocol.ProblemOfGame(hello) is { } problem)
            {
                throw new IOException($"Cannot drive over '{_folder}': {problem} Use programs of the same version.");
            }
        }
        catch (BridgeException e)
        {
            throw new IOException($"'{Path.Combine(_folder, BridgeProtocol.HelloFile)}' is not a valid hello of the game: {e.Message}", e);
        }
    }

    private string? ReadState() => Read("state.txt");

    private string? Read(string name)
    {
        try
        {
            using FileStream file = RegularFile.OpenRead(Path.Combine(_folder, name), FileShare.ReadWrite | FileShare.Delete);
            byte[] bytes = new byte[MaxStateLength];
            return Encoding.UTF8.GetString(bytes, 0, file.ReadAtLeast(bytes, bytes.Length, throwOnEndOfStream: false));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The file is being replaced or does not exist yet. If that lasts, no frame arrives, which is reported.
            return null;
        }
    }

    /// <summary>Parses a state; null if it is incomplete.</summary>
    private static ClientFrame? FrameOf(string state)
    {
        string[] words = state.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        double[] numbers = new double[Values];
        for (int i = 0; i < Values; i++)
        {
            if (i >= words.Length || !TryNumber(words[i], out numbers[i]))
            {
                return null;
            }
        }

        // The image's name is in between.
        if (words.Length < Values + 2 || !TryNumber(words[Values + 1], out double angleAhead))
        {
            return null;
        }

        LaneIndicators torcs = ClientIndicators.Of(numbers[..IndicatorTable.Count]);
        int frame = IndicatorTable.Count,
            time = frame + 1,
            speed = frame + 2,
            fast = frame + 3;
        DrivingState seen = new(
            ClientIndicators.InMetres(torcs, ClientIndicators.Ordinary, angleAhead),
            torcs,
            numbers[fast] > 0,
            numbers[speed]
        );
        return new ClientFrame((long)numbers[frame], numbers[time], seen, null);
    }

    private static bool TryNumber(string word, out double number) =>
        double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out number);

    private void Command(string json)
    {
        // A file of the same time and length would not be recognised as new, so blanks vary its length.
        _commands = (_commands + 1) % 16;
        WriteWhole("command.json", json + new string(' ', _commands));
    }

    private void WriteWhole(string name, string text)
    {
        string path = Path.Combine(_folder, name);
        var tried = Stopwatch.StartNew();
        while (true)
        {
            try
            {
                AtomicFile.Write(path, text, isDurable: false);
                return;
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException && tried.Elapsed < PatienceOfWriting)
            {
                Thread.Sleep(Poll);
            }
        }
    }
}
