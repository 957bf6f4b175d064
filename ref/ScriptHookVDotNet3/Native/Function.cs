using GTA.Hosting;

namespace GTA.Native;

/// <summary>Calls native functions of the game.</summary>
public static class Function
{
    /// <summary>Calls a native function for its result.</summary>
    /// <exception cref="InvalidOperationException">The calling thread is not the script's.</exception>
    public static unsafe T Call<T>(Hash hash, params InputArgument[] arguments) =>
        NativeValue.To<T>((ulong*)NativeStack.Call(hash, arguments, typeof(T)));

    /// <summary>Calls a native function.</summary>
    /// <exception cref="InvalidOperationException">The calling thread is not the script's.</exception>
    public static void Call(Hash hash, params InputArgument[] arguments) => NativeStack.Call(hash, arguments, null);
}
