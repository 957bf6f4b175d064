using System.Globalization;
using System.Text;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

/// <summary>Does to a shared folder what clients, other programs, networks and people do to folders, at random.</summary>
internal sealed class FolderVandal(string folder, int seed) : IDisposable
{
    private static readonly string[] Names =
    [
        "controls.txt",
        "indicators.txt",
        "command.json",
        "alive.txt",
        "state.txt",
        "state.txt.0123456789abcdef.partial",
    ];

    private static readonly string[] Contents =
    [
        "0.25 0.5 0 12\n",
        "0.1 -7 3.5 7 75 75 -9.5 -1.6 2.4 5.5 75 30 40 3\n",
        """{"type":"controls","steering":-0.25,"throttle":0.5,"brake":0.1}""",
        """{"type":"reset","position":[1,2,3],"headingDegrees":90}""",
        """{"type":"environment","weather":"rain","timeOfDay":"17:30"}""",
        """{"type":"pause","paused":true}""",
        """{"type":"pause","paused":false}""",
        """{"type":"step","seconds":0.1}""",
        """{"type":"requestFrame"}""",
        """{"type":"hello"}""",
    ];

    private readonly Random _random = new(seed);
    private readonly List<FileStream> _locks = [];
    private int _strangers;

    /// <summary>Makes a folder writable for everybody again.</summary>
    public static void Allow(string folder)
    {
        if (!OperatingSystem.IsWindows() && Directory.Exists(folder))
        {
            File.SetUnixFileMode(folder, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        }
    }

    public void DoSomething()
    {
        try
        {
            Do(Path.Combine(folder, Names[_random.Next(Names.Length)]));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            // The bridge was quicker, or an earlier deed is in the way.
            return;
        }
    }

    /// <summary>Takes back what would keep a good client from driving.</summary>
    public void Mend()
    {
        Allow(folder);
        Directory.CreateDirectory(folder);
        _locks.ForEach(file => file.Dispose());
        _locks.Clear();
        foreach (string name in Names)
        {
            // The bridge may be at it just now.
            Frames.Await(() => TryRemove(Path.Combine(folder, name)), $"{name} to go");
        }
    }

    public void Dispose() => Mend();

    private static bool TryRemove(string path)
    {
        try
        {
            Remove(path);
            return true;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    private static void Remove(string path)
    {
        if (Directory.Exists(path) && new DirectoryInfo(path).LinkTarget is null)
        {
            Directory.Delete(path, recursive: true);
        }
        else
        {
            File.Delete(path);
        }
    }

    private void Do(string path)
    {
        if (new FileInfo(path).LinkTarget is not null)
        {
            // What it leads to is nobody's to write to or to lock.
            File.Delete(path);
        }

        switch (_random.Next(13))
        {
            case 0 or 1:
                File.WriteAllText(path, Mutated());
                break;
            case 2:
                File.WriteAllText(path + ".new", Mutated());
                File.Move(path + ".new", path, overwrite: true);
                break;
            case 3:
                string whole = Contents[_random.Next(Contents.Length)];
                File.WriteAllText(path, whole[.._random.Next(whole.Length)]);
                break;
            case 4:
                File.WriteAllBytes(path, Bytes(_random.Next(2_000)));
                break;
            case 5:
                File.WriteAllBytes(path, Bytes(_random.Next(65_000, 1_000_000)));
                break;
            case 6:
                Remove(path);
                Directory.CreateDirectory(Path.Combine(path, "inside"));
                break;
            case 7:
                Remove(path);
                break;
            case 8:
                _locks.Add(new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None));
                break;
            case 9:
                Remove(path);
                string[] targets = ["/dev/zero", "/dev/null", "nowhere", path, "."];
                File.CreateSymbolicLink(path, targets[_random.Next(targets.Length)]);
                break;
            case 10:
                for (int i = 0; i < 100; i++)
                {
                    File.WriteAllText(
                        Path.Combine(folder, string.Create(CultureInfo.InvariantCulture, $"stranger {++_strangers}.txt")),
                        "?"
                    );
                }

                break;
            case 11:
                File.SetLastWriteTimeUtc(path, new DateTime(_random.Next(1, 9999), 1, 1, 0, 0, 0, DateTimeKind.Utc));
                break;
            default:
                TakeAway();
                break;
        }
    }

    /// <summary>The whole folder: deleted, replaced by a file, or made inaccessible.</summary>
    private void TakeAway()
    {
        switch (_random.Next(3))
        {
            case 0:
                Directory.Delete(folder, recursive: true);
                break;
            case 1:
                Directory.Delete(folder, recursive: true);
                File.WriteAllText(folder, "no folder");
                Thread.Sleep(_random.Next(20));
                File.Delete(folder);
                break;
            default:
                if (!OperatingSystem.IsWindows())
                {
                    File.SetUnixFileMode(folder, UnixFileMode.UserRead | UnixFileMode.UserExecute);
                }

                break;
        }
    }

    private string Mutated()
    {
        var text = new StringBuilder(Contents[_random.Next(Contents.Length)]);
        for (int change = _random.Next(4); change > 0; change--)
        {
            text[_random.Next(text.Length)] = (char)_random.Next(1, 0x300);
        }

        return text.ToString();
    }

    private byte[] Bytes(int count)
    {
        byte[] bytes = new byte[count];
        _random.NextBytes(bytes);
        return bytes;
    }
}
