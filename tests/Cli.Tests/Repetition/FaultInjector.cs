using System.Diagnostics;
using System.Reflection;
using System.Runtime.InteropServices;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>
/// Lets one file operation of this process fail. The library is compiled from fault-injector.c and must be preloaded; it then gets the
/// calls of the runtime, and by <see cref="Attach"/> those of the program itself.
/// </summary>
internal static partial class FaultInjector
{
    private const string Library = "fault-injector";

    /// <summary>Compiles the library.</summary>
    /// <returns>Its path.</returns>
    public static string Compile(string folder)
    {
        string path = Path.Combine(folder, "fault-injector.so");
        string source = Path.Combine(AppContext.BaseDirectory, "Repetition", "fault-injector.c");
        string[] arguments = ["-O1", "-shared", "-fPIC", "-o", path, source, "-ldl", "-lpthread"];
        using Process compiler = Process.Start(new ProcessStartInfo("cc", arguments))!;
        compiler.WaitForExit();
        return compiler.ExitCode == 0 ? path : throw new InvalidOperationException("cc cannot compile the fault injector.");
    }

    /// <summary>Leads the calls of the program's own to libc through the library.</summary>
    public static void Attach(string path)
    {
        nint library = NativeLibrary.Load(path);
        Assembly[] callers = [typeof(AtomicFile).Assembly, typeof(FolderLock).Assembly, typeof(FaultInjector).Assembly];
        foreach (Assembly assembly in callers)
        {
            NativeLibrary.SetDllImportResolver(assembly, (name, _, _) => name is "libc" or Library ? library : 0);
        }
    }

    /// <summary>Begins to record the operations below a folder, and to let one of them fail.</summary>
    public static void Begin(string folder, Fault fault) =>
        Begin(
            folder,
            fault.Operation.Kind,
            fault.Operation.Path,
            fault.Operation.Number,
            fault.Error,
            fault.Kills ? 1
                : fault.Vanishes ? 2
                : 0,
            fault.CanExchange ? 1 : 0
        );

    /// <summary>Ends recording.</summary>
    /// <returns>Whether the operation came and failed.</returns>
    public static bool End() => Stop() != 0;

    /// <summary>The operations of the last recording, in their order.</summary>
    public static IReadOnlyList<FileOperation> Operations()
    {
        var numbers = new Dictionary<string, int>(StringComparer.Ordinal);
        var operations = new List<FileOperation>();
        foreach (string line in Marshal.PtrToStringUTF8(Recorded())!.Split('\n', StringSplitOptions.RemoveEmptyEntries))
        {
            int number = numbers.GetValueOrDefault(line);
            numbers[line] = number + 1;
            int space = line.IndexOf(' ', StringComparison.Ordinal);
            operations.Add(new FileOperation(line[..space], line[(space + 1)..], number));
        }

        return operations;
    }

    [LibraryImport(Library, EntryPoint = "fault_begin", StringMarshalling = StringMarshalling.Utf8)]
    private static partial void Begin(string folder, string kind, string path, int number, int error, int ending, int exchange);

    [LibraryImport(Library, EntryPoint = "fault_end")]
    private static partial int Stop();

    [LibraryImport(Library, EntryPoint = "fault_operations")]
    private static partial nint Recorded();
}
