/* SPDX-License-Identifier: BSD-3-Clause
 * consumer PLUGIN: loads the plug-in, prints its version and the ABI's, and unloads it. */
#include <cagewright/cagewright.h>
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

int main(int argc, char** argv) {
  void* library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
  if (library == NULL) {
    fprintf(stderr, "consumer: %s\n", argc == 2 ? dlerror() : "usage: consumer PLUGIN");
    return 1;
  }
  /* ISO C knows no cast from an object pointer to a function pointer. */
  void* symbol = dlsym(library, CGW_ENTRY_POINT);
  cgw_get_api_fn get_api = NULL;
  memcpy(&get_api, &symbol, sizeof get_api);
  const cgw_api* api = get_api != NULL ? get_api(CGW_ABI_MINOR) : NULL;
  if (api == NULL) {
    fprintf(stderr, "consumer: %s offers no %s\n", argv[1], CGW_ENTRY_POINT);
    return 1;
  }
  printf("cagewright %s, ABI %u\n", api->version, (unsigned)api->abi_major);
  return dlclose(library) == 0 ? 0 : 1;
}
