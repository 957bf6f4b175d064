using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;

namespace Harvester.Runs.Supervising;

/// <summary>
/// All processes that a program has started, also those that have detached themselves. On Linux only; elsewhere it is empty. A process
/// belongs to it that is a descendant of the program's, has the program's mark in its environment, or, where this process adopts orphans,
/// is a descendant of this one.
/// </summary>
public sealed class ProcessFamily
{
    /// <summary>The variable of the environment that has the mark.</summary>
    public const string Variable = "HARVESTER_SUPERVISED";

    private const int SetChildSubreaper = 36;
    private const int GetChildSubreaper = 37;

    private readonly byte[] _entry;

    /// <summary>Makes a mark of its own.</summary>
    public ProcessFamily()
    {
        Mark = Guid.NewGuid().ToString("N");
        _entry = Encoding.ASCII.GetBytes($"{Variable}={Mark}\0");
    }

    /// <summary>The value of <see cref="Variable"/> with which the program is started.</summary>
    public string Mark { get; }

    /// <summary>
    /// Makes this process the parent of all orphans among its descendants, so that a daemon cannot leave the family. To be called only by
    /// a process that starts nothing but the program.
    /// </summary>
    public static void AdoptOrphans()
    {
        if (OperatingSystem.IsLinux())
        {
            _ = Prctl(SetChildSubreaper, 1, 0, 0, 0);
        }
    }

    /// <summary>The numbers of the processes that run.</summary>
    /// <param name="program">Numbers of the program's own processes that run.</param>
    public IReadOnlyList<int> Running(IEnumerable<int> program)
    {
        if (!OperatingSystem.IsLinux())
        {
            return [];
        }

        Dictionary<int, (int Parent, bool IsRunning)> all = All();
        HashSet<int> own = [.. program];
        var others = all.Keys.Where(id => id != Environment.ProcessId && (IsMarked(id) || HasAncestor(id)));
        return [.. own.Union(others).Where(id => all.TryGetValue(id, out var state) && state.IsRunning)];

        bool HasAncestor(int id)
        {
            // A process that ends meanwhile can leave a cycle of numbers.
            int steps = 0;
            for (int parent = all[id].Parent; steps < all.Count; parent = all[parent].Parent, steps++)
            {
                if (own.Contains(parent) || (parent == Environment.ProcessId && IsAdopting()))
                {
                    return true;
                }

                if (!all.ContainsKey(parent))
                {
                    return false;
                }
            }

            return false;
        }
    }

    private static Dictionary<int, (int Parent, bool IsRunning)> All()
    {
        var all = new Dictionary<int, (int, bool)>();
        foreach (string folder in Directory.EnumerateDirectories("/proc"))
        {
            if (
                int.TryParse(Path.GetFileName(folder), NumberStyles.None, CultureInfo.InvariantCulture, out int id)
                && Read(folder, "stat") is { Length: > 0 } bytes
            )
            {
                // Number, name in brackets, state, parent; the name may have brackets and spaces of its own.
                string stat = Encoding.UTF8.GetString(bytes);
                string[] fields = stat[(stat.LastIndexOf(')') + 2)..].Split(' ');
                all[id] = (int.Parse(fields[1], CultureInfo.InvariantCulture), fields[0] is not ("Z" or "X"));
            }
        }

        return all;
    }

    private bool IsMarked(int id) => Read($"/proc/{id.ToString(CultureInfo.InvariantCulture)}", "environ").AsSpan().IndexOf(_entry) >= 0;

    /// <summary>A file of a process; empty if the process has ended, or is another user's.</summary>
    private static byte[] Read(string folder, string name)
    {
        try
        {
            return File.ReadAllBytes(Path.Combine(folder, name));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }

    private static bool IsAdopting() => Prctl(GetChildSubreaper, out int isSet, 0, 0, 0) == 0 && isSet != 0;

    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "prctl")]
    private static extern int Prctl(int option, nuint value, nuint third, nuint fourth, nuint fifth);

    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "prctl")]
    private static extern int Prctl(int option, out int value, nuint third, nuint fourth, nuint fifth);
}
