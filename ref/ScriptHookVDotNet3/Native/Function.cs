using GTA.Hosting;

namespace GTA.Native;

/// <summary>Calls native functions of the game.</summary>
public static class Function
{
    /// <summary>Calls a native function for its result.</summary>
    public static T Call<T>(Hash hash, params InputArgument[] arguments) => (T)Dispatch(hash, arguments)!;

    /// <summary>Calls a native function.</summary>
    public static void Call(Hash hash, params InputArgument[] arguments) => Dispatch(hash, arguments);

    private static object? Dispatch(Hash hash, InputArgument[] arguments) =>
        GameHost.Current.Call(hash, System.Array.ConvertAll(arguments, argument => argument.Value));
}
